// Charts of a family: cost on x, error on y, one for each device.

import { LogAxis, number, percent, short } from "./numbers.js";
import { colours, ink, kShapes, paper } from "./theme.js";

export const kErrors = [["worst", "worst"], ["p999", "99.9th percentile"], ["rms", "root mean square"]];
export const kCosts = [["time", "time"], ["ratio", "time, as a ratio"], ["counts", "operations"], ["fetches", "image reads"]];

function costOf(point, kind) {
    switch (kind) {
        case "time": return point.cost && [point.cost.nanoseconds, point.cost.low, point.cost.high];
        case "ratio": return point.cost && [point.cost.ratio, point.cost.ratio_low, point.cost.ratio_high];
        case "counts": return point.counts && [point.counts.mean.total, null, null];
        default: return point.counts && [point.counts.mean.fetch, null, null];
    }
}

export function costTitle(chart, kind) {
    switch (kind) {
        case "time": return "ns per call";
        case "ratio": return `times the cost of ${chart.reference}`;
        case "counts": return "operations per call";
        default: return "image reads per call";
    }
}

export function errorTitle(chart, kind) {
    const unit = chart.measure === "absolute" ? chart.unit : chart.measure;
    return `${kErrors.find(([name]) => name === kind)[1]} error${unit ? ", " + unit : ""}`;
}

// The sum over all scenes is one of them only where there are several.
function scenesOf(chart) {
    const scenes = [...new Set(chart.points.map(point => point.scene))];
    return scenes.length === 2 && scenes.includes("all") ? scenes.filter(scene => scene !== "all") : scenes;
}

// The costs that any point of the family has, and whether any has errors.
export function offered(chart) {
    return {
        costs: kCosts.filter(([kind]) => chart.points.some(point => number(costOf(point, kind)?.[0] ?? NaN) >= 0 &&
            (kind !== "fetches" || point.counts.mean.fetch > 0))),
        hasErrors: chart.points.some(point => point.accuracy),
        devices: [...new Set(chart.points.filter(point => point.accuracy || point.cost || point.counts).map(point => point.device))],
        scenes: scenesOf(chart),
    };
}

const settingsText = settings => Object.entries(settings).map(([name, value]) => `${name}=${value}`).join(", ");

export const remarkOf = point => [point.reason, point.refused ? "refused by what the family accepts" : "", point.front ? "on the front" : ""].filter(Boolean).join("; ");

function rowOf(point, choice) {
    const [cost, low, high] = costOf(point, choice.cost);
    const accuracy = point.accuracy;
    const row = {
        label: point.label, member: point.member, settings: settingsText(point.settings), device: point.device,
        cost: number(cost), low: number(low ?? cost), high: number(high ?? cost), front: point.front,
        refused: point.refused ?? false, remark: remarkOf(point),
        time: point.cost ? `${short(point.cost.nanoseconds)} ns (${short(point.cost.low)} to ${short(point.cost.high)})` : "",
        ratio: Number.isFinite(point.cost?.ratio) ? `${short(point.cost.ratio)}×` : "",
        operations: point.counts ? `${short(point.counts.mean.total)}, ${short(point.counts.mean.fetch)} image reads` : "",
    };
    if (accuracy) {
        Object.assign(row, {
            error: number(accuracy[choice.error]), worst: number(accuracy.worst),
            errors: `${short(accuracy.worst)} · ${short(accuracy.p999)} · ${short(accuracy.rms)}`,
            bits: short(accuracy.bits), missed: accuracy.missed, wrong: accuracy.wrong,
            shares: accuracy.missed === undefined ? "" : `${percent(accuracy.missed)} · ${percent(accuracy.wrong)}`,
        });
    }
    return row;
}

// Marks the rows of the front: those that no row of the front beats, by less error at a cost that is
// less or alike, or by the same error at less cost; costs whose spreads meet are alike. The front
// of the worst error against the chart's own cost is marked already.
function markFront(chart, rows, choice) {
    const own = chart.cost_by === "operations" ? ["counts"] : ["time", "ratio"];
    if (choice.error === "worst" && own.includes(choice.cost)) return;
    const beats = (a, b) => a.error < b.error ? a.low <= b.high : a.error === b.error && a.high < b.low;
    const candidates = rows.filter(row => !row.refused && Number.isFinite(row.error));
    const front = [];
    for (const row of candidates.sort((a, b) => a.error - b.error || a.low - b.low)) {
        if (!front.some(other => beats(other, row))) front.push(row);
    }
    for (const row of rows) {
        row.front = front.includes(row);
    }
}

// The rows of a device, and its axes: errors, ratios and counts have one scale on all devices, times
// have one on each.
export function familyRows(chart, choice, device) {
    const points = chart.points.filter(point => point.scene === choice.scene && point.accuracy && costOf(point, choice.cost));
    const all = points.map(point => rowOf(point, choice));
    const rows = all.filter(row => row.device === device);
    markFront(chart, rows, choice);
    const x = new LogAxis((choice.cost === "time" ? rows : all).map(row => row.cost));
    const y = new LogAxis(all.flatMap(row => [row.error, row.worst]));
    for (const row of rows) {
        Object.assign(row, { x: x.at(row.cost), x1: x.at(row.low), x2: x.at(row.high), y: y.at(row.error), y2: y.at(row.worst) });
    }
    return { rows, x, y };
}

// Names of points of the front that fit without covering one another, as [{x, y, label, align}].
function labels(front, rows, { x, y }, width, height) {
    const place = (axis, value, size) => size * Math.log(value / axis.low) / Math.log(axis.high / axis.low);
    const taken = rows.map(row => {
        const at = [place(x, row.x, width), height - place(y, row.y, height)];
        return { left: at[0] - 5, right: at[0] + 5, top: at[1] - 5, bottom: at[1] + 5 };
    });
    const shown = [];
    for (const row of front) {
        const at = [place(x, row.x, width), height - place(y, row.y, height)];
        const length = 5.5 * row.label.length;
        for (const [align, left, dy] of [["left", at[0] + 9, -9], ["left", at[0] + 9, 12], ["right", at[0] - 9 - length, -9], ["right", at[0] - 9 - length, 12]]) {
            const box = { left, right: left + length, top: at[1] + dy - 6, bottom: at[1] + dy + 6 };
            const isFree = box.left >= 0 && box.right <= width && box.top >= 0 && box.bottom <= height &&
                taken.every(other => box.right < other.left || box.left > other.right || box.bottom < other.top || box.top > other.bottom);
            if (isFree) {
                taken.push(box);
                shown.push({ x: row.x, y: row.y, label: row.label, align, dy });
                break;
            }
        }
    }
    return shown;
}

function tooltip(chart) {
    return [
        { field: "label", title: "method" }, { field: "settings", title: "settings" }, { field: "time", title: "time" },
        ...(chart.reference ? [{ field: "ratio", title: `against ${chart.reference}` }] : []),
        { field: "operations", title: "operations" },
        { field: "errors", title: "worst · 99.9 % · rms" }, { field: "bits", title: "bits" },
        ...(chart.search ? [{ field: "shares", title: "missed · wrong" }] : []),
        { field: "device", title: "device" }, { field: "remark", title: "remark" },
    ];
}

const quantity = (field, axis, title, more = {}) => ({
    field, type: "quantitative", title,
    scale: { type: "log", domain: axis.domain, nice: false },
    axis: { values: axis.ticks, labelExpr: axis.labels, grid: true, ...more },
});

function legendOf(width) {
    return { orient: "bottom", columns: Math.max(1, Math.floor(width / 190)), title: null };
}

// choice: { scene, error, cost }; size: { width, height, isDark }.
export function familySpec(chart, choice, device, { width, height = 320, isDark = false }) {
    const { rows, x, y } = familyRows(chart, choice, device);
    const members = [...new Set(chart.points.map(point => point.member))];
    const front = rows.filter(row => row.front).sort((a, b) => a.x - b.x || b.y - a.y);
    const steps = front.length ? [...front, { ...front.at(-1), x: x.high }] : [];
    const names = labels(front, rows, { x, y }, width, height);
    const xOf = quantity("x", x, chart.search ? null : costTitle(chart, choice.cost));
    const yOf = quantity("y", y, errorTitle(chart, choice.error));
    const looks = range => ({ domain: members, range });
    // Beyond eight members colours come again, with other shapes.
    const shapes = looks(members.map((_, index) => kShapes[(index + 3 * Math.floor(index / kShapes.length)) % kShapes.length]));
    const hues = looks(members.map((_, index) => colours(isDark)[index % kShapes.length]));
    const member = { field: "member", type: "nominal", sort: members, legend: { ...legendOf(width), values: members.filter(member => rows.some(row => row.member === member)) } };
    const dimmed = { condition: { test: "datum.front", value: 1 }, value: 0.4 };
    const layer = [
        { data: { values: steps }, mark: { type: "line", interpolate: "step-after", strokeWidth: 1.5, color: ink(isDark), opacity: 0.55 },
            encoding: { x: xOf, y: yOf, order: { field: "x" } } },
        { mark: { type: "rule", strokeWidth: 1 }, encoding: { x: quantity("x1", x), x2: { field: "x2" }, y: yOf, opacity: dimmed } },
    ];
    if (choice.error !== "worst") {
        layer.push({ mark: { type: "rule", strokeWidth: 1, strokeDash: [2, 2] }, encoding: { x: xOf, y: yOf, y2: { field: "y2" }, opacity: dimmed } });
        layer.push({ mark: { type: "tick", orient: "horizontal", size: 10, thickness: 2, color: ink(isDark) }, encoding: { x: xOf, y: quantity("y2", y), opacity: dimmed } });
    }
    layer.push({
        mark: { type: "point", size: 90, strokeWidth: 1.6 },
        encoding: {
            x: xOf, y: yOf, stroke: { ...member, scale: hues }, fill: { ...member, scale: hues }, shape: { ...member, scale: shapes }, strokeOpacity: { condition: { test: "datum.front", value: 1 }, value: 0.55 },
            fillOpacity: { condition: { test: "datum.front", value: 1 }, value: 0 },
        },
    });
    for (const align of ["left", "right"]) {
        for (const dy of [-9, 12]) {
            const values = names.filter(name => name.align === align && name.dy === dy);
            if (!values.length) continue;
            for (const halo of [true, false]) {
                layer.push({
                    data: { values },
                    mark: { type: "text", align, dx: align === "left" ? 9 : -9, dy, baseline: "middle",
                        ...(halo ? { stroke: paper(isDark), strokeWidth: 3, strokeOpacity: 0.85 } : {}) },
                    encoding: { x: xOf, y: yOf, text: { field: "label" } },
                });
            }
        }
    }
    layer.push({ mark: { type: "point", filled: true, size: 500, opacity: 0 }, encoding: { x: xOf, y: yOf, tooltip: tooltip(chart) } });
    const main = { width, height, data: { values: rows }, layer };
    const title = { text: device };
    if (!chart.search) return { title, ...main };
    return { title, vconcat: [main, sharesSpec(chart, choice, rows, x, width)], spacing: 12,
        resolve: { scale: { shape: "independent", stroke: "independent", fill: "independent", color: "independent" }, legend: { shape: "independent" } } };
}

// Of a search: shares of rays that miss what they should hit, and of those that hit something else.
function sharesSpec(chart, choice, rows, x, width) {
    const values = rows.flatMap(row => ["missed", "wrong"].map(kind => ({ ...row, kind, share: 100 * number(row[kind]) })));
    const greatest = Math.max(1, ...values.map(row => row.share));
    const kind = { field: "kind", type: "nominal", title: null, scale: { domain: ["missed", "wrong"] } };
    return {
        width, height: 90, data: { values },
        mark: { type: "point", size: 55, strokeWidth: 1.5 },
        encoding: {
            x: quantity("x", x, costTitle(chart, choice.cost)),
            y: { field: "share", type: "quantitative", title: "% of rays", scale: { domain: [0, greatest] }, axis: { tickCount: 4 } },
            shape: { ...kind, scale: { domain: ["missed", "wrong"], range: ["circle", "cross"] }, legend: { orient: "bottom" } },
            stroke: { ...kind, scale: { domain: ["missed", "wrong"], range: ["#0072b2", "#d55e00"] }, legend: { orient: "bottom" } },
            tooltip: tooltip(chart),
        },
    };
}

// A family without truths: what each point costs, beside what its source says.
export function costSpec(chart, choice, device, { width, isDark = false }) {
    const points = chart.points.filter(point => point.scene === choice.scene && point.device === device && costOf(point, choice.cost));
    const hasPublished = choice.cost === "ratio" && points.some(point => number(point.published_ratio ?? NaN) > 0);
    const values = points.flatMap(point => {
        const row = rowOf(point, choice);
        const rows = [{ ...row, kind: "measured", value: row.cost, text: short(row.cost) }];
        if (hasPublished && number(point.published_ratio ?? NaN) > 0) {
            rows.push({ ...row, kind: "published", value: point.published_ratio, low: null, high: null, text: short(point.published_ratio) });
        }
        return rows;
    });
    for (const row of values) row.end = Math.max(row.value, row.high ?? 0);
    const order = points.map(point => point.label);
    const axis = new LogAxis(values.map(row => row.value));
    const isWide = axis.high / axis.low > 300;
    const kinds = hasPublished ? ["measured", "published"] : ["measured"];
    const scale = isWide ? { type: "log", domain: axis.domain } : { domainMin: 0 };
    const x = { field: "value", type: "quantitative", title: costTitle(chart, choice.cost), scale };
    const y = { field: "label", type: "nominal", sort: order, title: null, axis: { labelLimit: Math.max(90, width * 0.45) } };
    const yOffset = { field: "kind", type: "nominal", sort: kinds };
    const base = isWide ? { x2: { datum: axis.low } } : {};
    const fill = { field: "kind", type: "nominal", scale: { domain: kinds, range: ["#0072b2", isDark ? "#8b949e" : "#c3c9cf"] },
        legend: hasPublished ? { orient: "bottom", title: null } : null };
    return {
        title: { text: device }, width: Math.max(140, width * 0.55), height: { step: hasPublished ? 15 : 22 }, data: { values },
        layer: [
            { mark: { type: "bar" }, encoding: { x, y, yOffset, fill, ...base, tooltip: tooltip(chart) } },
            { mark: { type: "rule", strokeWidth: 1.5, color: ink(isDark) }, encoding: { x: { ...x, field: "low" }, x2: { field: "high" }, y, yOffset } },
            { mark: { type: "text", align: "left", dx: 5, baseline: "middle" }, encoding: { x: { ...x, field: "end" }, y, yOffset, text: { field: "text" } } },
        ],
    };
}
