// The sections of the page beside the matrix.

import { chart, endCharts } from "./views.js";
import { choice, command, el, table } from "./dom.js";
import { count, number, percent, short } from "./numbers.js";
import { glyph } from "./pictures.js";
import { inputsOf, observation } from "./record.js";
import { budgetRows, budgetSpec, sweepSpec } from "./specs_errors.js";
import { costSpec, familySpec, kErrors, offered, remarkOf } from "./specs_family.js";
import { coarse, hasCells, kMarks, kPanels, mapSpec, marksSeen } from "./specs_map.js";
import { kVerdicts, rankOf, usedText, wordOf } from "./verdicts.js";

// Charts with their controls: `draw(state)` gives the elements for what is chosen.
function chosen(state, controls, draw) {
    const body = el("div", {});
    const redraw = () => {
        endCharts(body);
        body.replaceChildren(...draw(state));
    };
    const selects = controls.filter(([, , options]) => options.length > 1).map(([name, label, options]) =>
        choice(label, options, state[name], value => { state[name] = value; redraw(); }));
    redraw();
    return [selects.length ? el("div", { class: "controls" }, selects) : null, body];
}

const sceneName = scene => (scene === "all" ? "all scenes" : scene || "all");

// Verdicts by device, and how much of its tolerance the worst passed record used.
export function verdictTable(run) {
    const words = kVerdicts.map(({ word }) => word).filter(word => run.records.some(record => wordOf(record) === word)).reverse();
    const rows = run.devices.map(({ name }) => {
        const records = run.records.filter(record => record.device === name);
        const passed = records.filter(record => record.verdict === "pass" && record.worst);
        const worst = passed.reduce((a, b) => (a && number(a.worst.used) >= number(b.worst.used) ? a : b), null);
        return [name, ...words.map(word => count(records.filter(record => wordOf(record) === word).length)), worst ? `${usedText(worst)} ` : "",
            worst ? el("span", { class: "path" }, worst.case) : ""];
    });
    const headings = ["device", ...words.map(word => `${kVerdicts[rankOf(word)].sign} ${word}`), "most used of a tolerance", "by"];
    return table(headings, rows, { class: "numbers", "aria-label": "verdicts by device" });
}

export function budgetCharts(run) {
    const words = kVerdicts.map(({ word }) => word).filter(word => run.records.some(record => wordOf(record) === word && budgetRows([record], record.device, 1).length)).reverse();
    const devices = run.devices.map(({ name }) => name).filter(name => budgetRows(run.records, name, 1).length);
    if (!devices.length) return null;
    const topicOf = record => record.case.slice(0, record.case.indexOf("/") + 1);
    const topics = [...new Set(run.records.map(topicOf))].sort();
    const state = { device: devices[0], most: "12", word: words.find(word => rankOf(word) > rankOf("known")) ?? (words.includes("pass") ? "pass" : words[0]), topic: "" };
    const controls = [["device", "Device", devices.map(name => [name, name])], ["topic", "Folder", [["", "all"], ...topics.filter(Boolean).map(topic => [topic, topic])]],
        ["word", "Verdict", words.map(word => [word, word])], ["most", "Cases", [["12", "12"], ["40", "40"]]]];
    return el("div", {}, chosen(state, controls, ({ device, word, most, topic }) => {
        const rows = budgetRows(run.records.filter(record => wordOf(record) === word && (!topic || topicOf(record) === topic)), device, Number(most));
        return rows.length ? [chart(size => budgetSpec(rows, device, size), `the greatest parts of errors on ${device}`)] : [el("p", {}, "No such case has an error here.")];
    }));
}

function pointsTable(family, scene) {
    const points = family.points.filter(point => point.scene === scene);
    const has = test => points.some(test);
    const columns = [
        ["method", point => point.label], ["device", point => point.device], ["worst", point => short(point.accuracy.worst), point => point.accuracy], ["99.9 %", point => short(point.accuracy.p999), point => point.accuracy],
        ["rms", point => short(point.accuracy.rms), point => point.accuracy], ["bits", point => short(point.accuracy.bits), point => point.accuracy],
        ["missed", point => percent(point.accuracy.missed), point => family.search && point.accuracy], ["wrong", point => percent(point.accuracy.wrong), point => family.search && point.accuracy],
        ["ns", point => `${short(point.cost.nanoseconds)} (${short(point.cost.low)} to ${short(point.cost.high)})`, point => point.cost],
        ["ratio", point => `${short(point.cost.ratio)}×`, point => Number.isFinite(point.cost?.ratio)], ["published", point => `${short(point.published)}${point.published_ratio !== undefined ? ` (${short(point.published_ratio)}×)` : ""}`, point => point.published !== undefined && point.published !== null],
        ["operations", point => short(point.counts.mean.total), point => point.counts], ["image reads", point => short(point.counts.mean.fetch), point => point.counts],
        ["worst input, and how to repeat it", point => el("span", {}, inputsOf(point.accuracy.worst_inputs), command(point.accuracy.repeat)), point => point.accuracy?.repeat],
        ["remark", remarkOf, remarkOf],
    ].filter(([, , test]) => !test || has(test));
    const rows = points.map(point => columns.map(([, text, test]) => (!test || test(point) ? text(point) : "")));
    return table(columns.map(([name]) => name), rows, { class: "numbers", "aria-label": `all points of ${family.family}` });
}

function boundsTable(family, scene) {
    const bounds = (family.bounds ?? []).filter(bound => bound.scene === scene);
    if (!bounds.length) return null;
    const devices = [...new Set(bounds.map(bound => bound.device))];
    const rows = [...new Set(bounds.map(bound => bound.text))].flatMap(text => ["worst", "p999"].filter(by => bounds.some(bound => bound.text === text && bound.by === by)).map(by => [
        text, (by === "worst" ? "worst" : "99.9 %") + (family.search ? " of right hits" : ""), ...devices.map(device => {
            const found = bounds.find(bound => bound.text === text && bound.by === by && bound.device === device);
            const point = found && found.point !== null ? family.points[found.point] : null;
            if (!point) return el("span", { class: "soft" }, "none");
            const byCounts = family.cost_by === "operations" || !point.cost;
            const off = family.search ? ["missed", "wrong"].filter(share => point.accuracy[share] > 0).map(share => `, ${percent(point.accuracy[share])} ${share}`).join("") : "";
            return `${point.label}: ${byCounts ? `${short(point.counts?.mean.total ?? NaN)} operations` : `${short(point.cost.nanoseconds)} ns`}${off}`;
        })]));
    return [el("h4", {}, "The cheapest that holds a bound"), table(["error at most", "by", ...devices], rows, { class: "words", "aria-label": "bounds" })];
}

export function familyArticle(family) {
    const { costs, devices, hasErrors, scenes } = offered(family);
    const state = { scene: scenes.includes("all") ? "all" : scenes[0], error: "worst", cost: costs.some(([kind]) => kind === "ratio") && !hasErrors ? "ratio" : costs[0]?.[0] };
    const make = hasErrors ? familySpec : costSpec;
    const controls = [["scene", "Scene", scenes.map(scene => [scene, sceneName(scene)])],
        ...(hasErrors ? [["error", "Error", kErrors]] : []), ["cost", "Cost", costs]];
    return el("article", { id: `chart-${family.family}` }, el("h3", {}, family.quantity, " ", el("span", { class: "path soft" }, family.family)),
        el("p", {}, family.description),
        family.at ? el("p", { class: "soft" }, `At one input: ${family.at}.`) : null,
        family.published_unit ? el("p", { class: "soft" }, `Published figures: ${family.published_unit}.`) : null,
        hasErrors ? el("p", { class: "soft" }, "Filled points joined by a line are the front: none is both cheaper and more accurate, where costs whose spreads meet count as equal. Hollow, faint points are dominated. Where an average is shown, a dash marks the worst.") : null,
        chosen(state, controls, choice_ => [
            el("p", { class: "soft" }, (family.scenes ?? []).find(scene => scene.name === choice_.scene)?.description ?? ""),
            costs.length ? el("div", { class: "facets" }, devices.map(device => chart(size => make(family, choice_, device, size), `${family.quantity} on ${device}: error against cost`))) : el("p", {}, "No point has a cost."),
            ...(boundsTable(family, choice_.scene) ?? []),
            el("details", {}, el("summary", {}, "All points"), pointsTable(family, choice_.scene)),
        ]));
}

function agreementText({ device, safe, safe_held, fails, failed }) {
    return `${safe === safe_held && fails === failed ? "✓ agrees" : "✗ differs"} on ${device}: of ${count(fails)} cells where theory says that it fails, ${count(failed)} do; of ${count(safe)} where it says that it holds, ${count(safe_held)} do`;
}

export function mapArticle(whole, key) {
    const { map, block } = coarse(whole);
    const shown = map.devices.filter(hasCells);
    const state = { panel: "error" };
    const panels = kPanels.filter(([panel]) => panel === "error" || map[panel]);
    const legend = marksSeen(map).map(mark => el("span", {}, el("b", {}, glyph(mark) || "▒"), ` ${kMarks[mark]?.says ?? mark}`));
    return el("article", { id: `map-${key}` }, el("h3", {}, el("span", { class: "path" }, map.case), ` over ${map.x.name} and ${map.y.name}`),
        map.description ? el("p", {}, map.description) : null,
        el("p", { class: "soft" }, `Output ${map.output}, by ${map.tolerance}${map.fixed ? `; the other inputs ${map.fixed}` : ""}.`),
        map.prediction ? el("p", {}, `Theory: ${map.prediction.because.replace(/\.?$/, ".")} `, el("span", { class: "soft" }, [map.prediction.fails && `Fails where ${map.prediction.fails} (solid line). `, map.prediction.safe && `Holds where ${map.prediction.safe} (dashed line).`].filter(Boolean).join(""))) : null,
        ...chosen(state, [["panel", "Show", panels]], ({ panel }) => [
            panel === "error" ? el("p", { class: "legend" }, legend) : null,
            block ? el("p", { class: "soft" }, `Each cell that is drawn is the worst of ${block}.`) : null,
            el("div", { class: "facets" }, (panel === "error" ? shown : shown.slice(0, 1)).map(device =>
                chart(size => mapSpec(map, panel, device, size), `${map.case} on ${device.device}: ${panel}`))),
        ].filter(Boolean)),
        map.prediction?.agreement ? el("ul", {}, map.prediction.agreement.map(each => el("li", {}, agreementText(each)))) : null,
        map.devices.filter(device => device.reason).map(device => el("p", {}, `${device.device}: ${device.reason}`)),
        shown.filter(device => device.worst).map(device => el("details", {}, el("summary", {}, `Worst on ${device.device}`), observation(device.worst))),
        map.repeat ? command(map.repeat) : null);
}

export function sweepArticle(sweep) {
    const seen = [["worst_ulp", "Worst"], ["worst_used", "Most used of the tolerance"], ["first_refused", "First refused"]];
    return el("article", {}, el("h3", {}, el("span", { class: "path" }, sweep.case), ` over ${sweep.input}, on ${sweep.device} `, el("span", { class: `verdict ${sweep.verdict}` }, `${kVerdicts[rankOf(sweep.verdict)].sign} ${sweep.verdict}`)),
        el("p", {}, `${sweep.shard ? `Part ${sweep.shard} of e` : "E"}very float from ${sweep.from.decimal} to ${sweep.to.decimal}: ${count(sweep.rows)} of ${count(sweep.all_rows)} values judged (${sweep.recipe})${sweep.fixed ? `; the other inputs ${sweep.fixed}` : ""}.`),
        sweep.reason ? el("p", {}, sweep.reason) : null,
        sweep.outputs.map(output => [
            chart(size => sweepSpec(output, `${output.output}, by ${output.rule}: ${count(output.refused)} of ${count(output.judged)} refused`, size), `histogram of the errors of ${output.output}`),
            seen.filter(([name]) => output[name]).map(([name, title]) => el("details", { open: name === "worst_ulp" }, el("summary", {}, `${title}: ${short(output[name].ulp_error)} ulp`),
                observation({ ...output[name], output: output.output, rule: output.rule }), output[name].repeat ? command(output[name].repeat) : null)),
        ]),
        el("p", { class: "soft" }, `${sweep.driver}, fingerprint ${sweep.fingerprint}`));
}

// Every device that any section names, once for each of its fingerprints.
export function deviceTable(report) {
    const found = new Map();
    for (const device of [...(report.run?.devices ?? []), ...Object.values(report.charts ?? {}).flatMap(family => family.devices ?? [])]) {
        found.set(`${device.name} ${device.fingerprint}`, device);
    }
    const rows = [...found.values()].map(device => [device.name, el("code", {}, device.fingerprint), `${device.driver} ${device.version}`, device.api, device.description, device.compiler,
        (device.features ?? []).join(" "), (device.float_controls ?? []).join(" ")]);
    return rows.length ? table(["device", "fingerprint", "driver", "interface", "calls itself", "compiler", "features", "float controls"], rows, { class: "words", "aria-label": "devices" }) : null;
}
