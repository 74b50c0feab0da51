// Charts on the page: drawn when they come near the window, anew when its width or its light
// changes, and all of them before it is printed.

import { View, Warn, parse } from "vega";
import { compile } from "vega-lite";
import { Handler } from "vega-tooltip";
import { theme } from "./theme.js";
import { el } from "./dom.js";

const charts = new Set();
const chartOf = new WeakMap();
const near = new WeakSet();
let dark, print, tooltips, seen, sized;

class Chart {
    constructor(host, make) {
        this.host = host;
        this.make = make;
        this.view = null;
        this.width = 0;
        this.drawing = Promise.resolve();
    }

    draw() {
        this.drawing = this.drawing.then(() => this.drawNow());
        return this.drawing;
    }

    async drawNow() {
        // A folded section has no width; its charts are drawn once it opens.
        const width = Math.floor(this.host.clientWidth);
        if (!this.host.isConnected || width < 50) return;
        const isDark = dark.matches && !print.matches;
        this.width = width;
        const { spec } = compile({ ...this.make({ width: Math.max(160, width - 76), isDark }), config: theme(isDark) });
        this.view?.finalize();
        this.view = new View(parse(spec), { renderer: "canvas", logLevel: Warn, hover: true, tooltip: tooltips.call });
        await this.view.initialize(this.host).runAsync();
        this.host.dataset.drawn = "";
    }

    end() {
        this.view?.finalize();
        seen.unobserve(this.host);
        sized.unobserve(this.host);
        charts.delete(this);
    }
}

// Once, before the first chart. Not at load: `--svg` loads these modules where there is no window.
export function startCharts() {
    dark = matchMedia("(prefers-color-scheme: dark)");
    print = matchMedia("print");
    tooltips = new Handler({ theme: "custom" });
    seen = new IntersectionObserver(entries => {
        for (const { target, isIntersecting } of entries) {
            if (!isIntersecting || near.has(target)) continue;
            near.add(target);
            chartOf.get(target).draw();
        }
    }, { rootMargin: "400px" });
    sized = new ResizeObserver(entries => {
        for (const { target } of entries) {
            const chart = chartOf.get(target);
            if (near.has(target) && Math.abs(target.clientWidth - chart.width) > 8) chart.draw();
        }
    });
    dark.addEventListener("change", () => { for (const each of charts) if (near.has(each.host)) each.draw(); });
}

// An element that shows the Vega-Lite specification that `make({ width, isDark })` gives.
export function chart(make, label) {
    const host = el("div", { class: "chart", role: "img", "aria-label": label });
    const made = new Chart(host, make);
    charts.add(made);
    chartOf.set(host, made);
    seen.observe(host);
    sized.observe(host);
    return host;
}

// Before the elements in it are taken away.
export function endCharts(element) {
    for (const each of [...charts]) if (element.contains(each.host)) each.end();
}

export function drawAll() {
    return Promise.all([...charts].map(each => (near.add(each.host), each.draw())));
}
