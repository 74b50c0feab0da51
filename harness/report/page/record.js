// What opens beneath a row of the matrix: everything about the records of one case.

import { command, el } from "./dom.js";
import { count, number, percent, short } from "./numbers.js";
import { rankOf, signOf, usedText, wordOf } from "./verdicts.js";

const value = ({ decimal, hex }) => [el("span", {}, decimal), hex && hex !== decimal ? el("span", { class: "hex" }, ` = ${hex}`) : null];

function facts(pairs) {
    return el("dl", { class: "facts" }, pairs.filter(([, text]) => text !== null && text !== undefined && text !== "")
        .map(([name, text]) => el("div", {}, el("dt", {}, name), el("dd", {}, text))));
}

export function inputsOf(inputs) {
    const pairs = Array.isArray(inputs) ? inputs : Object.entries(inputs ?? {});
    return el("span", { class: "inputs" }, pairs.map(([name, { decimal, hex }]) =>
        el("span", { class: "input" }, el("b", {}, name), `=${decimal}`, hex && hex !== decimal ? el("span", { class: "hex" }, ` ${hex}`) : null)));
}

function allowedText(allowed) {
    if (!allowed) return null;
    if (allowed === "unbounded") return "anything";
    return el("span", {}, value(allowed.low), " to ", value(allowed.high));
}

export function observation(seen) {
    return facts([
        ["output", `${seen.output}, by ${seen.rule}`],
        ["input", inputsOf(seen.inputs)],
        ["actual", el("span", {}, value(seen.actual))],
        ["expected", seen.expected ? el("span", {}, value(seen.expected)) : null],
        ["error", `${short(seen.ulp_error)} ulp, ${short(seen.error)} absolute`],
        ["specification allows", allowedText(seen.allowed)],
    ]);
}

// The parts of an error in ulp as bars, on a logarithmic scale of this record's own.
function budgetBars(budget, title) {
    const parts = ["method", "rounding", "driver"].filter(part => budget[part]);
    const sizes = parts.map(part => number(budget[part].ulp));
    const greatest = Math.max(1, ...sizes.filter(Number.isFinite));
    const least = 1 / 16;
    const width = size => (size <= least ? 0 : !Number.isFinite(size) ? 100 : 4 + 96 * Math.log(size / least) / Math.log(greatest / least));
    return el("div", { class: "budget" }, el("div", { class: "label" }, title),
        parts.map((part, index) => el("div", { class: "bar" }, el("span", {}, part),
            el("span", { class: "track" }, el("span", { class: `fill ${part}`, style: `width:${Math.max(0, Math.min(100, width(sizes[index]))).toFixed(1)}%` })),
            el("span", {}, `${short(sizes[index])} ulp`))));
}

function shareText(share) {
    const wrong = `wrong ${count(share.wrong)} of ${count(share.rows)} (${percent(share.wrong / Math.max(1, share.rows))}, ${percent(share.wrong_allowed)} allowed)`;
    if (share.hits === undefined) return `${share.output}: ${wrong}`;
    return `${share.output}: missed ${count(share.missed)} of ${count(share.hits)} hits (${percent(share.missed / Math.max(1, share.hits))}, ` +
        `${percent(share.missed_allowed)} allowed), ${wrong}, worst right hit off by ${short(share.worst_right)}`;
}

function oneRecord(record, isOpen) {
    const word = wordOf(record);
    const outside = word === "nonconforming" ? record.specification?.worst_outside : null;
    const seen = outside ?? record.worst;
    const held = record.specification;
    const summary = el("summary", {}, el("span", { class: `verdict ${word}` }, `${signOf(word)} ${word}`), ` ${record.device} `,
        el("span", { class: "soft" }, `(${record.recipe})`), usedText(record) ? ` ${usedText(record)} of the tolerance` : "");
    return el("details", { open: isOpen, class: "record" }, summary,
        facts([
            ["reason", record.reason],
            ["known cause", record.known_cause],
            ["once went wrong", record.flake],
            ["figures", record.figures?.length ? el("span", {}, record.figures.map(figure => el("div", {}, `expected ${figure.expected}, seen ${figure.seen}: ${figure.agrees ? "agrees" : "does not agree"}`))) : null],
            ["shares", record.shares?.length ? el("span", {}, record.shares.map(share => el("div", {}, shareText(share)))) : null],
            ["refused", record.refused ? `${count(record.refused)} of ${count(record.judged)} values (${count(record.rows)} rows)` : null],
            ["judged", record.refused ? null : record.judged ? `${count(record.judged)} values (${count(record.rows)} rows)` : null],
            ["blamed", Object.entries(record.culprits ?? {}).map(([part, values]) => `${part}: ${count(values)}`).join(", ")],
            ["specification", held?.profile ? `${held.profile}: ${count(held.outside)} of ${count(held.held)} values outside, ${count(held.unbounded)} without a bound` : null],
        ]),
        seen ? el("h4", {}, outside ? "Furthest outside the specification" : "Worst input") : null,
        seen ? observation(seen) : null,
        el("div", { class: "budgets" },
            seen?.budget && ["method", "rounding", "driver"].some(part => number(seen.budget[part]?.ulp ?? 0) > 0)
                ? budgetBars(seen.budget, `parts of this error${seen.budget.culprit ? `, blamed on ${seen.budget.culprit}` : ""}`) : null,
            Object.keys(record.worst_parts ?? {}).length ? budgetBars(record.worst_parts, "greatest parts over all inputs") : null),
        record.repeat ? command(record.repeat) : null);
}

// Of all devices and recipes of a case, the worst first and open.
export function caseDetails(records) {
    const used = record => (record.worst ? number(record.worst.used) : -1);
    const sorted = [...records].sort((a, b) => rankOf(wordOf(b)) - rankOf(wordOf(a)) || used(b) - used(a));
    return el("div", { class: "records" }, sorted.map((record, index) => oneRecord(record, index === 0)));
}
