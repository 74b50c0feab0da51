// Charts as SVG without a browser, for `--svg`.

import { View, parse } from "vega";
import { compile } from "vega-lite";
import { budgetRows, budgetSpec, sweepSpec } from "./specs_errors.js";
import { costSpec, familySpec, offered } from "./specs_family.js";
import { coarse, hasCells, kMarks, kPanels, mapSpec, marksSeen } from "./specs_map.js";
import { theme } from "./theme.js";

const kWidth = 460;

// Lines no longer than a chart is wide, about.
function wrapped(text, most = 84) {
    const lines = [""];
    for (const word of text.split(" ")) {
        const line = lines[lines.length - 1];
        if (line && line.length + 1 + word.length > most) lines.push(word);
        else lines[lines.length - 1] = line ? `${line} ${word}` : word;
    }
    return lines;
}

function side(specs, title, subtitle, more = {}) {
    return { title: { text: wrapped(title, 62), subtitle, fontSize: 15, offset: 12 }, columns: 2, spacing: 28, concat: specs, ...more };
}

function familyPictures(chart, name) {
    const { costs, devices, hasErrors, scenes } = offered(chart);
    const pictures = {};
    for (const scene of scenes) {
        for (const [cost, says] of costs) {
            if (cost === (hasErrors ? "ratio" : "time") && costs.length > 1) continue;
            const choice = { scene, cost, error: "worst" };
            const make = hasErrors ? familySpec : costSpec;
            const specs = devices.map(device => make(chart, choice, device, { width: kWidth }));
            const suffix = (scene ? `-${scene}` : "") + `-${cost}`;
            const subtitle = [scene && scene !== "all" ? `scene: ${scene}` : scene === "all" ? "all scenes" : "", hasErrors ? `worst error against ${says}` : says].filter(Boolean).join("; ");
            pictures[`chart-${name}${suffix}`] = side(specs, chart.quantity, subtitle, hasErrors ? { resolve: { scale: { x: "independent", y: "independent" } } } : {});
        }
    }
    return pictures;
}

function mapPictures(whole, name) {
    const { map, block } = coarse(whole);
    const shown = map.devices.filter(hasCells);
    const says = marksSeen(map).filter(mark => kMarks[mark]?.shape).map(mark => `${glyph(mark)} ${mark}`).join("   ");
    const title = `${map.case}: ${map.output}${map.fixed ? ` at ${map.fixed}` : ""}`;
    const theory = map.prediction ? `theory: ${map.prediction.because}` : "";
    const pictures = {};
    for (const [panel] of kPanels) {
        if (panel !== "error" && !map[panel]) continue;
        const devices = panel === "error" ? shown : shown.slice(0, 1);
        if (!devices.length) continue;
        pictures[`map-${name}${panel === "error" ? "" : `-${panel}`}`] =
            side(devices.map(device => mapSpec(map, panel, device, { width: kWidth, merge: true })), title, [panel === "error" ? says : "", block && `each cell is the worst of ${block}`, ...wrapped(theory)].filter(Boolean));
    }
    return pictures;
}

export const glyph = mark => ({ circle: kMarks[mark].filled ? "•" : "○", square: "□", cross: "✚", diamond: "◆", "triangle-up": "▲", "triangle-down": "▼", stroke: "–" })[kMarks[mark].shape] ?? "";

function specsOf(section, data, name) {
    switch (section) {
        case "charts": return familyPictures(data, name);
        case "maps": return mapPictures(data, name);
        case "sweeps": return { [`sweep-${name}`]: side(data.outputs.map(output => sweepSpec(output, `${output.output}, by ${output.rule}`, { width: 640 })), `${data.case}: every float of ${data.input} on ${data.device}`, data.fixed) };
        default: {
            const records = data.records.filter(record => record.verdict === "pass");
            const specs = data.devices.map(device => [device.name, budgetRows(records, device.name, 20)])
                .filter(([, rows]) => rows.length).map(([device, rows]) => budgetSpec(rows, device, { width: 760 }));
            return specs.length ? { budget: side(specs, "What the greatest errors are made of", "the greatest parts over the recipes and inputs of cases that passed") } : {};
        }
    }
}

// { "FILE.svg": "<svg ..." } of a part of report.json.
export async function pictures(section, key, data) {
    const name = key.replace(/[^A-Za-z0-9._=-]+/g, "-");
    const drawn = {};
    for (const [file, spec] of Object.entries(specsOf(section, data, name))) {
        const config = { ...theme(false), background: "#ffffff", padding: 12, aria: false };
        const compiled = compile({ ...spec, config });
        const view = new View(parse(compiled.spec), { renderer: "none" });
        // A hundredth of a pixel is enough, and halves the file.
        const svg = (await view.toSVG()).replace(/ (d|transform|x|y|x1|x2|y1|y2|width|height)="[^"]*"/g, attribute =>
            attribute.replace(/\d+\.\d{3,}/g, digits => String(Number(Number(digits).toFixed(2)))));
        drawn[`${file.replace(/[^A-Za-z0-9._=-]+/g, "-")}.svg`] = `${svg}\n`;
        view.finalize();
    }
    return drawn;
}
