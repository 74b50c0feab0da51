// Maps: what a method does over two of its inputs, as a picture.

import { LogAxis, number, short } from "./numbers.js";

export const kPanels = [["error", "error"], ["condition", "condition number"], ["disagreement", "devices' disagreement"]];

// What is drawn over a cell, and whether its error has a meaning.
export const kMarks = {
    holds: { shape: null, hasError: true, says: "accepted" },
    refused: { shape: "circle", size: 0.24, filled: true, hasError: true, says: "refused: beyond the tolerance" },
    spent: { shape: "square", size: 0.55, filled: false, hasError: true, says: "spent: the budget of iterations was used up" },
    missed: { shape: "circle", size: 0.6, filled: false, hasError: false, says: "missed: there is a hit, and none was found" },
    wrong: { shape: "cross", size: 0.65, filled: true, hasError: false, says: "wrong: another hit than the first, or one where there is none" },
    nan: { shape: "diamond", size: 0.65, filled: true, hasError: false, says: "NaN" },
    infinity: { shape: "triangle-up", size: 0.65, filled: true, hasError: false, says: "infinity" },
    undecided: { shape: "stroke", size: 0.6, filled: false, hasError: false, says: "undecided: no truth there" },
    crash: { shape: "triangle-down", size: 0.7, filled: true, hasError: false, says: "crash: the device gave no result" },
};
const kFlat = { missed: "#f0b6a0", wrong: "#d98cb8", nan: "#8f8f8f", infinity: "#b5b5b5", undecided: "#ececec", crash: "#b08d6e" };
const kPlainAxis = {
    grid: false, tickCount: 6, labelOverlap: true,
    labelExpr: "datum.value !== 0 && (abs(datum.value) < 1e-3 || abs(datum.value) >= 1e5) ? format(datum.value, '.0e') : format(datum.value, '~r')",
};
const kLargestSign = 30;
const kSteps = 4;  // colours in a decade

// A device that cannot run the program has none.
export const hasCells = device => device.mark.length > 0;

const isLog = (axis, edges) => axis.scale === "log" && edges.every(edge => number(edge) > 0);

function scaleOf(axis) {
    const edges = axis.edges.map(number);
    const type = isLog(axis, edges) ? "log" : "linear";
    return { type, domain: [edges[0], edges.at(-1)], nice: false, ...(type === "linear" ? { zero: false } : {}) };
}

// Of a logarithmic axis that spans few decades 1, 2 and 5 of each, else the decades.
function ticksOf(axis) {
    const [low, high] = [number(axis.edges[0]), number(axis.edges.at(-1))];
    if (!isLog(axis, [low]) || high < 4 * low) return kPlainAxis;
    const decades = Math.log10(high / low);
    const values = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power += Math.ceil(decades / 9)) {
        for (const step of decades < 3.5 ? [1, 2, 5] : [1]) values.push(Number(`${step}e${power}`));
    }
    return { ...kPlainAxis, tickCount: values.length, labelOverlap: "greedy", values: values.filter(value => value >= low * 0.9999 && value <= high * 1.0001) };
}

// More cells across or upwards than this are as small as pixels, and too many for a browser.
const kMostCells = 320;
// From the best to the worst, as the program orders them.
const kFromBest = ["holds", "undecided", "refused", "wrong", "missed", "spent", "infinity", "nan", "crash"];

// The map in blocks of cells where it has too many to draw, each as the worst of its cells; and how
// many cells a block has: "4×4", "" for one.
export function coarse(map) {
    const [width, height] = [map.x.values.length, map.y.values.length];
    const [across, along] = [Math.ceil(width / kMostCells), Math.ceil(height / kMostCells)];
    if (across === 1 && along === 1) return { map, block: "" };
    const columns = Math.ceil(width / across);
    const blocks = Array.from({ length: columns * Math.ceil(height / along) }, () => []);
    for (let iy = 0; iy < height; ++iy) {
        for (let ix = 0; ix < width; ++ix) blocks[Math.floor(iy / along) * columns + Math.floor(ix / across)].push(iy * width + ix);
    }
    const worst = isWorse => blocks.map(cells => cells.reduce((found, cell) => (isWorse(cell, found) ? cell : found)));
    const greatest = values => values && worst((a, b) => number(values[a]) > number(values[b])).map(cell => values[cell]);
    const axisOf = (axis, step) => ({
        ...axis, edges: axis.edges.filter((_, index) => index % step === 0 || index === axis.edges.length - 1),
        values: axis.values.filter((_, index) => index % step === Math.min(step >> 1, axis.values.length - 1 - (index - index % step))),
    });
    const ranks = map.marks.map(mark => kFromBest.indexOf(mark));
    const devices = map.devices.map(device => {
        if (!hasCells(device)) return device;
        const { error, mark } = device;
        const cells = worst((a, b) => ranks[mark[a]] > ranks[mark[b]] || (mark[a] === mark[b] && number(error[a]) > number(error[b])));
        return { ...device, error: cells.map(cell => error[cell]), mark: cells.map(cell => mark[cell]) };
    });
    const forecasts = map.prediction?.cells;
    // Nothing is said of a block of which theory says several things.
    const prediction = forecasts ? { ...map.prediction, cells: blocks.map(([first, ...others]) => (others.every(cell => forecasts[cell] === forecasts[first]) ? forecasts[first] : 0)) } : null;
    return {
        map: { ...map, x: axisOf(map.x, across), y: axisOf(map.y, along), devices, prediction, condition: greatest(map.condition), disagreement: greatest(map.disagreement) },
        block: `${across}×${along}`,
    };
}

// The values that a panel shows of a device, by cell, and the marks, if it has any.
function panelOf(map, device, panel) {
    if (panel === "condition") return { values: map.condition, marks: null };
    if (panel === "disagreement") return { values: map.disagreement, marks: null };
    return { values: device.error, marks: device.mark.map(index => map.marks[index]) };
}

function titleOf(map, panel) {
    if (panel === "error") return map.measure === "ulp" ? "error, ulp" : `${map.measure} error`;
    return kPanels.find(([name]) => name === panel)[1];
}

// The colour's axis, which all devices share.
export function colourAxis(map, panel) {
    const values = [];
    for (const device of map.devices) {
        if (!hasCells(device) && panel === "error") continue;
        const { values: all, marks } = panelOf(map, device, panel);
        all.forEach((value, cell) => { if (!marks || kMarks[marks[cell]]?.hasError) values.push(value); });
        if (panel !== "error") break;
    }
    const axis = new LogAxis(values);
    // Anything below a millionth of the greatest is as good as exact to the eye.
    const greatest = axis.high / 1.6;
    axis.low = Math.max(axis.low, axis.hasInfinity ? axis.low : greatest * 1e-9);
    return axis;
}

const quantized = value => 10 ** (Math.round(Math.log10(value) * kSteps) / kSteps);

// The end of a cell, a little into the next one, which is drawn over it: no gaps between pixels.
function past(edges, index) {
    const reach = index + 2 < edges.length ? 0.3 * (edges[index + 1] - edges[index]) : 0;
    return edges[index + 1] + reach;
}

// Rectangles. `merge` joins neighbours of one look along x, for pictures on which nobody hovers.
function cellsOf(map, device, panel, axis, merge) {
    const { values, marks } = panelOf(map, device, panel);
    const [xs, ys] = [map.x.edges.map(number), map.y.edges.map(number)];
    const cells = [];
    for (let iy = 0; iy < map.y.values.length; ++iy) {
        let last = null;
        for (let ix = 0; ix < map.x.values.length; ++ix) {
            const index = iy * map.x.values.length + ix;
            const mark = marks ? marks[index] : "holds";
            const hasError = kMarks[mark]?.hasError ?? false;
            const value = hasError ? quantized(Math.max(axis.low, Math.min(axis.high, axis.at(values[index])))) : null;
            if (merge && last && last.flat === (hasError ? null : mark) && last.value === value) {
                last.x2 = past(xs, ix);
                continue;
            }
            last = { x1: xs[ix], x2: past(xs, ix), y1: ys[iy], y2: past(ys, iy), value, flat: hasError ? null : mark };
            cells.push(last);
            if (merge) continue;
            last.at = `${map.x.name}=${short(map.x.values[ix])}, ${map.y.name}=${short(map.y.values[iy])}`;
            last.error = short(values[index]);
            last.says = kMarks[mark]?.says ?? mark;
            if (map.condition) last.condition = short(map.condition[index]);
            if (map.disagreement) last.disagreement = short(map.disagreement[index]);
            if (map.prediction) last.theory = ["open", "holds", "fails"][map.prediction.cells[index]];
        }
    }
    return cells;
}

// Of cells in which a sign would be too small every second one has a sign, as on a chessboard, and
// those that stand alone.
function symbolsOf(map, device, axis, isSparse) {
    const width = map.x.values.length;
    const middle = Math.sqrt(axis.low * axis.high);
    const { mark: marks } = device;
    return marks.map((index, cell) => {
        const mark = map.marks[index];
        if (!kMarks[mark]?.shape) return null;
        const [ix, iy] = [cell % width, Math.floor(cell / width)];
        const hasLike = (ix > 0 && marks[cell - 1] === index) || (ix + 1 < width && marks[cell + 1] === index) || marks[cell - width] === index || marks[cell + width] === index;
        if (isSparse && (ix + iy) % 2 === 1 && hasLike) return null;
        const isDark = kMarks[mark].hasError && axis.at(device.error[cell]) > middle;
        return { x: number(map.x.values[ix]), y: number(map.y.values[iy]), mark, isDark };
    }).filter(symbol => symbol);
}

// Edges between cells that are of `kind` and cells that are not, joined to long lines.
export function boundary(cells, kind, xs, ys) {
    const width = xs.length - 1;
    const height = ys.length - 1;
    const is = (ix, iy) => cells[iy * width + ix] === kind;
    const lines = [];
    const trace = (outer, inner, differs, line) => {
        for (let a = 1; a < outer; ++a) {
            let start = null;
            for (let b = 0; b <= inner; ++b) {
                const here = b < inner && differs(a, b);
                if (here && start === null) start = b;
                if (!here && start !== null) {
                    lines.push(line(a, start, b));
                    start = null;
                }
            }
        }
    };
    trace(width, height, (ix, iy) => is(ix - 1, iy) !== is(ix, iy), (ix, from, to) => ({ x: xs[ix], x2: xs[ix], y: ys[from], y2: ys[to] }));
    trace(height, width, (iy, ix) => is(ix, iy - 1) !== is(ix, iy), (iy, from, to) => ({ x: xs[from], x2: xs[to], y: ys[iy], y2: ys[iy] }));
    return lines;
}

// The cell deepest inside the region of a kind, where its name goes; null where it is too thin.
export function heart(cells, kind, width, height) {
    const depth = new Array(width * height).fill(0);
    const at = (ix, iy) => (ix < 0 || iy < 0 || ix >= width || iy >= height ? 0 : depth[iy * width + ix]);
    const sweep = (ix, iy, dx, dy) => {
        const cell = iy * width + ix;
        if (cells[cell] !== kind) return;
        const near = 1 + Math.min(at(ix + dx, iy), at(ix, iy + dy), at(ix + dx, iy + dy));
        depth[cell] = dx < 0 ? near : Math.min(depth[cell], near);
    };
    for (let iy = 0; iy < height; ++iy) for (let ix = 0; ix < width; ++ix) sweep(ix, iy, -1, -1);
    for (let iy = height - 1; iy >= 0; --iy) for (let ix = width - 1; ix >= 0; --ix) sweep(ix, iy, 1, 1);
    const best = depth.reduce((found, each, cell) => (each > depth[found] ? cell : found), 0);
    return depth[best] >= 3 ? [best % width, Math.floor(best / width)] : null;
}

function theoryLayers(map, x, y) {
    const [xs, ys] = [map.x.edges.map(number), map.y.edges.map(number)];
    const lines = [];
    const names = [];
    // Where both run together the solid line covers the other.
    for (const [kind, strokeDash, name] of [[1, [5, 4], "theory: holds"], [2, [], "theory: fails"]]) {
        const values = boundary(map.prediction.cells, kind, xs, ys);
        const encoding = { x: { ...x, field: "x" }, x2: { field: "x2" }, y: { ...y, field: "y" }, y2: { field: "y2" } };
        for (const mark of [{ color: "#ffffff", strokeWidth: 4.5 }, { color: "#000000", strokeWidth: 2, strokeDash }]) {
            lines.push({ data: { values }, mark: { type: "rule", strokeCap: "square", ...mark }, encoding });
        }
        const cell = heart(map.prediction.cells, kind, xs.length - 1, ys.length - 1);
        if (cell) names.push({ x: number(map.x.values[cell[0]]), y: number(map.y.values[cell[1]]), name });
    }
    const halo = [{ stroke: "#ffffff", strokeWidth: 4, strokeJoin: "round" }, { fill: "#000000" }];
    return [...lines, ...halo.map(mark => ({
        data: { values: names }, mark: { type: "text", fontSize: 12, fontWeight: 600, ...mark },
        encoding: { x: { ...x, field: "x" }, y: { ...y, field: "y" }, text: { field: "name" } },
    }))];
}

// The marks that are seen on any device, for the legend.
export function marksSeen(map) {
    const seen = new Set(map.devices.flatMap(device => device.mark.map(index => map.marks[index])));
    return map.marks.filter(mark => seen.has(mark));
}

export function mapSpec(map, panel, device, { width, isDark = false, merge = false }) {
    const axis = colourAxis(map, panel);
    const [columns, rows] = [map.x.values.length, map.y.values.length];
    const height = Math.round(width * Math.min(1, Math.max(0.5, rows / columns)));
    const x = { type: "quantitative", title: map.x.name, scale: scaleOf(map.x), axis: ticksOf(map.x) };
    const y = { type: "quantitative", title: map.y.name, scale: scaleOf(map.y), axis: ticksOf(map.y) };
    const cells = cellsOf(map, device, panel, axis, merge);
    const place = { x: { ...x, field: "x1" }, x2: { field: "x2" }, y: { ...y, field: "y1" }, y2: { field: "y2" } };
    const tooltip = merge ? null : [
        { field: "at", title: "input" }, { field: "error", title: titleOf(map, panel) }, { field: "says", title: "result" },
        ...(map.condition ? [{ field: "condition", title: "condition number" }] : []),
        ...(map.disagreement ? [{ field: "disagreement", title: "disagreement" }] : []),
        ...(map.prediction ? [{ field: "theory", title: "theory" }] : []),
    ];
    const flats = marksSeen(map).filter(mark => !kMarks[mark]?.hasError);
    const layer = [{
        data: { values: cells.filter(cell => cell.flat === null) }, mark: { type: "rect", strokeWidth: 0 },
        encoding: {
            ...place, tooltip,
            color: {
                field: "value", type: "quantitative", title: titleOf(map, panel),
                scale: { type: "log", domain: axis.domain, scheme: "viridis", reverse: true, clamp: true },
                legend: { orient: "bottom", direction: "horizontal", gradientLength: Math.min(width - 20, 300), gradientThickness: 10, titleOrient: "left", values: axis.ticks, labelExpr: axis.labels, labelOverlap: true },
            },
        },
    }];
    if (panel === "error" && flats.length) {
        layer.push({
            data: { values: cells.filter(cell => cell.flat !== null) }, mark: { type: "rect", strokeWidth: 0 },
            encoding: { ...place, tooltip, fill: { field: "flat", type: "nominal", legend: null, scale: { domain: flats, range: flats.map(mark => kFlat[mark]) } } },
        });
    }
    if (panel === "error") {
        const side = Math.min(width / columns, height / rows);
        layer.push(...symbolLayers(symbolsOf(map, device, axis, side < 9), { x, y }, side < 9 ? 1.5 * side : Math.min(side, kLargestSign)));
    }
    if (map.prediction) layer.push(...theoryLayers(map, x, y));
    return { title: { text: panel === "error" ? device.device : titleOf(map, panel) }, width, height, layer,
        resolve: { scale: { color: "independent", fill: "independent" } }, ...(isDark ? { view: { fill: "#ffffff" } } : {}) };
}

function symbolLayers(symbols, { x, y }, cell) {
    return [...new Set(symbols.map(symbol => symbol.mark))].map(mark => {
        const { shape, size, filled } = kMarks[mark];
        return {
            data: { values: symbols.filter(symbol => symbol.mark === mark) },
            mark: { type: "point", shape, filled, size: Math.max(3, (cell * size) ** 2), strokeWidth: Math.min(1.2, cell / 6), opacity: 1 },
            encoding: {
                x: { ...x, field: "x" }, y: { ...y, field: "y" },
                [filled ? "fill" : "stroke"]: { condition: { test: "datum.isDark", value: "#ffffff" }, value: "#000000" },
            },
        };
    });
}
