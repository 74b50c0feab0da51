// The matrix of cases by devices. It may have tens of thousands of rows: they are kept in groups,
// of which only those near the window hold elements.

import { el } from "./dom.js";
import { count, number } from "./numbers.js";
import { caseDetails } from "./record.js";
import { kVerdicts, rankOf, signOf, usedText, wordOf } from "./verdicts.js";

const kGroup = 40;      // rows
const kRowHeight = 31;  // px, until it is known
const kOpenAtOnce = 150;  // cases up to which all folders are open at first

const used = record => (record.worst ? number(record.worst.used) : -1);
const folderOf = path => path.slice(0, Math.max(0, path.lastIndexOf("/")));
const ancestors = path => {
    const parts = folderOf(path).split("/").filter(Boolean);
    return parts.map((_, index) => parts.slice(0, index + 1).join("/"));
};

// "fail vulkan -spirv": every word must be somewhere, those after '-' nowhere.
function matcher(text) {
    const words = text.toLowerCase().split(/\s+/).filter(word => word && word !== "-");
    const wanted = words.filter(word => word[0] !== "-");
    const unwanted = words.filter(word => word[0] === "-").map(word => word.slice(1));
    return hay => wanted.every(word => hay.includes(word)) && !unwanted.some(word => hay.includes(word));
}

export class Matrix {
    constructor(run) {
        this.rows = run.records.map(record => ({ record, word: wordOf(record), hay: `${record.case} ${record.device} ${record.recipe} ${wordOf(record)}`.toLowerCase() }))
            .sort((a, b) => (a.record.case < b.record.case ? -1 : a.record.case > b.record.case ? 1 : 0));
        this.devices = run.devices.map(device => device.name);
        this.devices.push(...new Set(run.records.map(record => record.device).filter(name => !this.devices.includes(name))));
        this.openCases = new Set();
        const cases = new Set(run.records.map(record => record.case));
        this.folders = new Set([...cases].flatMap(ancestors));
        this.openFolders = new Set(cases.size <= kOpenAtOnce ? this.folders : []);
        this.isWhole = false;
        this.head = el("tr");
        this.table = el("table", { class: "matrix" }, el("caption", { class: "aside" }, "cases by devices"), el("thead", {}, this.head));
        this.scroller = el("div", { class: "scroll tall", tabindex: "0", role: "group", "aria-label": "the matrix of cases by devices" }, this.table);
        this.status = el("p", { class: "soft", role: "status" });
        this.near = new IntersectionObserver(entries => {
            for (const { target, isIntersecting } of entries) isIntersecting ? this.fill(target) : this.empty(target);
        }, { root: this.scroller, rootMargin: "900px" });
        this.input = el("input", { type: "search", placeholder: "case, device, recipe or verdict; -word leaves out", autocomplete: "off", spellcheck: "false", oninput: () => this.show() });
        this.element = el("div", {}, this.controls(), this.status, this.scroller);
        this.show();
    }

    controls() {
        const words = kVerdicts.map(({ word, sign, says }) => ({ word, sign, says, number: this.rows.filter(row => row.word === word).length })).filter(({ number: all }) => all > 0).reverse();
        return el("div", { class: "controls", role: "search" },
            el("label", {}, "Filter ", this.input),
            el("span", { class: "chips" }, words.map(({ word, sign, says, number: all }) =>
                el("button", { type: "button", title: says, class: `chip verdict ${word}`, onclick: () => this.filter(this.input.value.trim() === word ? "" : word) }, `${sign} ${word} ${count(all)}`))),
            el("button", { type: "button", onclick: () => { this.openFolders = new Set(this.folders); this.show(); } }, "Unfold all"),
            el("button", { type: "button", onclick: () => { this.openFolders.clear(); this.show(); } }, "Fold all"));
    }

    filter(text) {
        this.input.value = text;
        this.show();
    }

    // Brings the table up to what is filtered and open.
    show() {
        const text = this.input.value.trim();
        const matches = matcher(text);
        const shown = text ? this.rows.filter(row => matches(row.hay)) : this.rows;
        const cases = new Map();
        for (const { record } of shown) {
            const records = cases.get(record.case);
            records ? records.push(record) : cases.set(record.case, [record]);
        }
        const present = new Set(shown.map(({ record }) => record.device));
        this.columns = this.devices.filter(device => present.has(device));
        this.items = this.itemsOf(cases, shown, text !== "");
        this.head.replaceChildren(el("th", { scope: "col" }, "case"), ...this.columns.map(device => el("th", { scope: "col" }, device.replace(":", ":\u200b"))));
        this.table.setAttribute("aria-rowcount", this.items.length + 1);
        this.status.textContent = `${count(cases.size)} cases, ${count(shown.length)} of ${count(this.rows.length)} records on ${this.columns.length} devices`;
        this.group();
    }

    // Folders and cases in the order of the table, without what is folded.
    itemsOf(cases, shown, isFiltered) {
        const counts = new Map();
        for (const { record, word } of shown) {
            for (const folder of ancestors(record.case)) {
                let devices = counts.get(folder);
                if (!devices) counts.set(folder, devices = new Map());
                let words = devices.get(record.device);
                if (!words) devices.set(record.device, words = new Map());
                words.set(word, (words.get(word) ?? 0) + 1);
            }
        }
        const isOpen = folder => isFiltered || this.isWhole || this.openFolders.has(folder);
        const items = [];
        const named = new Set();
        for (const [path, records] of cases) {
            const folders = ancestors(path);
            let isVisible = true;
            for (const [depth, folder] of folders.entries()) {
                if (isVisible && !named.has(folder)) items.push({ folder, depth, counts: counts.get(folder), isOpen: isOpen(folder) });
                named.add(folder);
                isVisible &&= isOpen(folder);
            }
            if (isVisible) items.push({ path, records, depth: folders.length });
        }
        return items;
    }

    group() {
        this.near.disconnect();
        for (const body of [...this.table.tBodies]) body.remove();
        for (let first = 0; first < this.items.length; first += kGroup) {
            const body = el("tbody");
            body.items = this.items.slice(first, first + kGroup);
            body.first = first;
            body.height = body.items.length * kRowHeight;
            this.table.append(body);
            this.isWhole || first === 0 ? this.fill(body) : this.empty(body);
            this.near.observe(body);
        }
    }

    fill(body) {
        if (body.isFilled) return;
        body.replaceChildren(...body.items.flatMap((item, index) => this.rowsOf(item, body.first + index)));
        body.isFilled = true;
    }

    empty(body) {
        if (this.isWhole || (body.isFilled && body.contains(document.activeElement))) return;
        if (body.isFilled) body.height = body.offsetHeight;
        const space = el("td", { colspan: this.columns.length + 1, class: "space", style: `height:${body.height}px` });
        body.replaceChildren(el("tr", { "aria-hidden": "true" }, space));
        body.isFilled = false;
    }

    rowsOf(item, index) {
        return item.folder !== undefined ? [this.folderRow(item, index)] : this.caseRows(item, index);
    }

    folderRow({ folder, depth, counts, isOpen }, index) {
        const toggle = () => {
            isOpen ? this.openFolders.delete(folder) : this.openFolders.add(folder);
            this.show();
            this.table.querySelector(`button[data-folder="${CSS.escape(folder)}"]`)?.focus();
        };
        return el("tr", { class: "folder", "aria-rowindex": index + 2 },
            el("th", { scope: "row", style: `--depth:${depth}` }, el("button", { type: "button", "aria-expanded": String(isOpen), "data-folder": folder, onclick: toggle }, `${folder.slice(folder.lastIndexOf("/") + 1)}/`)),
            this.columns.map(device => {
                const words = counts.get(device);
                return el("td", {}, words ? kVerdicts.filter(({ word }) => words.has(word)).reverse().map(({ word, sign }) =>
                    el("span", { class: `verdict ${word}`, title: `${words.get(word)} ${word}` }, `${sign}\u00a0${words.get(word)}`)) : null);
            }));
    }

    caseRows({ path, records, depth }, index) {
        const isOpen = this.openCases.has(path);
        const button = el("button", { type: "button", "aria-expanded": String(isOpen), title: path }, path.slice(path.lastIndexOf("/") + 1));
        const row = el("tr", { class: "case", "aria-rowindex": index + 2 }, el("th", { scope: "row", style: `--depth:${depth}` }, button),
            this.columns.map(device => this.cell(records.filter(record => record.device === device))));
        button.addEventListener("click", () => {
            const open = !this.openCases.has(path);
            open ? this.openCases.add(path) : this.openCases.delete(path);
            button.setAttribute("aria-expanded", String(open));
            open ? row.after(this.detailsRow(path, records)) : row.nextElementSibling.remove();
        });
        const isBad = records.some(record => rankOf(wordOf(record)) > rankOf("known"));
        return isOpen || (this.isWhole && isBad) ? [row, this.detailsRow(path, records)] : [row];
    }

    detailsRow(path, records) {
        return el("tr", { class: "details" }, el("td", { colspan: this.columns.length + 1 }, el("div", { class: "detail" }, el("h3", {}, path), caseDetails(records))));
    }

    // The worst verdict over the recipes, and what was used of the tolerance at most.
    cell(records) {
        if (!records.length) return el("td", { class: "none" }, "");
        const worst = records.reduce((a, b) => (rankOf(wordOf(b)) - rankOf(wordOf(a)) || used(b) - used(a)) > 0 ? b : a);
        const word = wordOf(worst);
        const text = usedText(worst);
        return el("td", { class: `verdict ${word}`, title: `${word}, ${worst.recipe}${text ? `: ${text} of the tolerance` : ""}` },
            `${signOf(word)} `, word === "pass" ? text : `${word}${text && word !== "skip" ? ` ${text}` : ""}`);
    }

    // All rows at once, for print; and back.
    whole(isWhole) {
        if (this.isWhole === isWhole) return;
        this.isWhole = isWhole;
        this.show();
    }
}
