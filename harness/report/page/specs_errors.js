// Charts of errors: a sweep's histogram, and what the errors of a run are made of.

import { LogAxis, count, number, percent, short } from "./numbers.js";
import { ink } from "./theme.js";

// "exact", "≤ 1/64", "≤ 4", "more", "∞, NaN"
function binName(bins, index) {
    const bin = bins[index];
    if (!bin.is_finite) return "∞, NaN";
    const upper = number(bin.up_to_ulp);
    if (upper === 0) return "exact";
    if (!Number.isFinite(upper)) return `> ${short(bins[index - 1].up_to_ulp)}`;
    return `≤ ${upper < 1 ? `1/${1 / upper}` : short(upper)}`;
}

export function sweepSpec(output, title, { width, height = 220, isDark = false }) {
    const all = output.histogram;
    const last = all.reduce((found, bin, index) => (bin.count > 0 ? index : found), 0);
    const first = all.findIndex(bin => bin.count > 0);
    const total = Math.max(1, all.reduce((sum, bin) => sum + bin.count, 0));
    const values = all.map((bin, index) => ({ index, name: binName(all, index), count: Math.max(bin.count, 0.5), values: count(bin.count), share: percent(bin.count / total) }))
        .slice(Math.max(0, first), last + 1);
    const names = values.map(bin => bin.name);
    const y = { field: "count", type: "quantitative", title: "values", scale: { type: "log", domain: [0.5, 1.8 * total], nice: false }, axis: { values: [1, 1e2, 1e4, 1e6, 1e8, 1e10], format: "~s" } };
    const x = { field: "name", type: "ordinal", sort: names, title: "error in ulp", axis: { labelAngle: width / names.length < 46 ? -60 : 0 } };
    const layer = [{ mark: { type: "bar", color: "#0072b2" }, encoding: { x, y, y2: { datum: 0.5 }, tooltip: [{ field: "name", title: "error, ulp" }, { field: "values", title: "values" }, { field: "share", title: "share" }] } }];
    if (width / names.length >= 46) {
        layer.push({ mark: { type: "text", dy: -7, fontSize: 10, color: ink(isDark) }, encoding: { x, y, text: { field: "share" } } });
    }
    return { title: { text: title }, width, height, data: { values }, layer };
}

export const kParts = ["method", "rounding", "driver"];
const kPartColours = ["#0072b2", "#e69f00", "#009e73"];
const kPartShapes = { method: "●", rounding: "■", driver: "▲" };

// The cases whose greatest finite part of an error is greatest on a device, over all their recipes.
// Those with infinite parts alone come last: they would tell nothing of the others' sizes.
export function budgetRows(records, device, most) {
    const worst = new Map();
    for (const record of records) {
        if (record.device !== device || !record.worst_parts) continue;
        const row = worst.get(record.case) ?? { case: record.case, greatest: 0 };
        worst.set(record.case, row);
        for (const part of kParts) {
            const seen = number(record.worst_parts[part]?.ulp ?? 0);
            const ulp = Number.isNaN(seen) ? Infinity : seen;
            row[part] = Math.max(row[part] ?? 0, ulp);
            if (Number.isFinite(ulp)) row.greatest = Math.max(row.greatest, ulp);
        }
    }
    return [...worst.values()].filter(row => kParts.some(part => row[part] > 0)).sort((a, b) => b.greatest - a.greatest).slice(0, most);
}

export function budgetSpec(rows, device, { width, isDark = false }) {
    const axis = new LogAxis([1 / 4, 1, ...rows.flatMap(row => kParts.map(part => row[part] ?? 0))]);
    axis.low = 1 / 8;
    axis.hasZero = false;
    const values = rows.flatMap(row => kParts.map(part => ({ case: row.case, part, value: axis.at(Math.max(row[part] ?? 0, axis.low)), says: `${kPartShapes[part]} ${short(row[part] ?? 0)}`, ulp: short(row[part] ?? 0) })));
    const x = { field: "value", type: "quantitative", title: "greatest part, ulp", scale: { type: "log", domain: axis.domain, nice: false }, axis: { values: axis.ticks, labelExpr: axis.labels } };
    const y = { field: "case", type: "nominal", sort: rows.map(row => row.case), title: null, axis: { labelLimit: Math.max(90, width * 0.4) } };
    const yOffset = { field: "part", type: "nominal", sort: kParts };
    return {
        title: { text: device, subtitle: kParts.map(part => `${kPartShapes[part]} ${part}`).join("   ") }, width: Math.max(120, width * 0.5), height: { step: 12 }, data: { values },
        layer: [
            { mark: { type: "bar" }, encoding: { x, x2: { datum: axis.low }, y, yOffset, fill: { field: "part", type: "nominal", scale: { domain: kParts, range: kPartColours }, legend: null }, tooltip: [{ field: "case", title: "case" }, { field: "part", title: "part" }, { field: "ulp", title: "ulp" }] } },
            { mark: { type: "text", align: "left", dx: 4, baseline: "middle", fontSize: 9.5, color: ink(isDark) }, encoding: { x, y, yOffset, text: { field: "says" } } },
        ],
    };
}
