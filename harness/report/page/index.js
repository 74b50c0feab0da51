// The page's start, and what the program calls for pictures.

import { el } from "./dom.js";
import { Matrix } from "./matrix.js";
import { count } from "./numbers.js";
import { budgetCharts, deviceTable, familyArticle, mapArticle, sweepArticle, verdictTable } from "./sections.js";
import { drawAll, startCharts } from "./views.js";
export { pictures } from "./pictures.js";

function section(id, title, ...children) {
    return el("section", { id, "aria-labelledby": `${id}-title` }, el("h2", { id: `${id}-title` }, title), ...children);
}

function entries(part) {
    return Object.entries(part ?? {});
}

// An article, or that there can be none: what another version wrote must not take all else away.
function articles(part, make) {
    return entries(part).map(([key, data]) => {
        try {
            return make(data, key);
        } catch (error) {
            return el("article", {}, el("h3", {}, el("span", { class: "path" }, key)), el("p", {}, `cannot be shown: it is not as this version of etalon writes it (${error.message})`));
        }
    });
}

// The sections that the report has something for.
function sectionsOf(report, matrix) {
    const { run } = report;
    const sections = [];
    if (run) {
        sections.push(section("run", "Cases by devices", verdictTable(run),
            el("p", { class: "soft" }, "A cell tells the worst verdict over the recipes, and how much of its tolerance the worst value used. A row opens its worst inputs. ",
                "This page leaves out some details of records that passed; ", el("a", { href: "report.json" }, "report.json"), " beside it has everything."),
            el("p", { class: "soft print-only" }, "In print the details of cases that passed, or that fail as they are expected to, are left out."),
            matrix.element));
        const budget = budgetCharts(run);
        if (budget) sections.push(section("budget", "What errors are made of", el("p", { class: "soft" }, "The greatest parts of an error that the method, binary32's rounding and the driver make, of the cases where they are greatest."), budget));
    }
    const charts = articles(report.charts, familyArticle);
    if (charts.length) sections.push(section("charts", "Speed against accuracy", charts));
    const maps = articles(report.maps, mapArticle);
    if (maps.length) sections.push(section("maps", "Where methods fail", maps));
    const sweeps = articles(report.sweeps, sweepArticle);
    if (sweeps.length) sections.push(section("sweeps", "Every float", sweeps));
    const devices = deviceTable(report);
    if (devices) sections.push(section("devices", "Devices and their fingerprints", devices,
        run?.absent?.length ? el("details", {}, el("summary", {}, `${count(run.absent.length)} that are not here`), el("ul", {}, run.absent.map(({ name, reason }) => el("li", {}, `${name}: ${reason}`)))) : null));
    return sections;
}

// Everything open and drawn while it is printed, and as it was afterwards.
function printWhole(matrix) {
    let opened = [];
    const before = () => {
        if (opened.length) return;
        matrix?.whole(true);
        opened = [...document.querySelectorAll("main details:not([open])")];
        for (const details of opened) details.open = true;
        drawAll();
    };
    const after = () => {
        for (const details of opened) details.open = false;
        opened = [];
        matrix?.whole(false);
        drawAll();
    };
    addEventListener("beforeprint", before);
    addEventListener("afterprint", after);
    matchMedia("print").addEventListener("change", ({ matches }) => (matches ? before() : after()));
}

export function startPage() {
    const report = JSON.parse(document.getElementById("data").textContent);
    startCharts();
    const matrix = report.run ? new Matrix(report.run) : null;
    const sections = sectionsOf(report, matrix);
    document.querySelector("header").append(
        el("p", { class: "soft" }, `etalon ${report.version} on ${report.processor}`),
        el("nav", { "aria-label": "sections" }, sections.map(each => el("a", { href: `#${each.id}` }, each.querySelector("h2").textContent))));
    document.querySelector("main").append(...sections);
    printWhole(matrix);
}
