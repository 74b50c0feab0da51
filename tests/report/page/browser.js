// A headless Chromium with a page of a report in it.

import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(join(process.env.ETALON_PAGE_MODULES, "package.json"));
export const library = name => require(name);

const puppeteer = library("puppeteer-core");

export async function launch() {
    return puppeteer.launch({
        executablePath: process.env.ETALON_CHROMIUM, headless: true,
        // Containers have no sandbox and little shared memory.
        args: ["--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--force-color-profile=srgb"],
    });
}

export function writePage(report) {
    const folder = mkdtempSync(join(tmpdir(), "etalon-page-"));
    const json = join(folder, "report.json");
    const html = join(folder, "index.html");
    writeFileSync(json, JSON.stringify(report));
    execFileSync(process.env.ETALON_WRITE_PAGE, [json, html]);
    return html;
}

// The page, and what it complained of and asked for since it was opened.
export async function openPage(browser, html, { width = 1280, height = 900, media = [] } = {}) {
    const page = await browser.newPage();
    await page.setViewport({ width, height });
    if (media.length) await page.emulateMediaFeatures(media);
    const complaints = [];
    const requests = [];
    page.on("pageerror", error => complaints.push(String(error)));
    page.on("console", message => { if (["error", "warn", "warning"].includes(message.type())) complaints.push(message.text()); });
    page.on("request", request => { if (!request.url().startsWith("data:")) requests.push(request.url()); });
    await page.goto(pathToFileURL(html).href, { waitUntil: "load" });
    return { page, complaints, requests };
}

// Brings an element into the window and waits until its chart is drawn.
export async function drawn(page, selector) {
    await page.evaluate(wanted => document.querySelector(wanted).scrollIntoView({ block: "center", behavior: "instant" }), selector);
    await page.waitForSelector(`${selector}[data-drawn]`, { timeout: 20000 });
    // What is drawn above it moves it.
    await page.evaluate(wanted => document.querySelector(wanted).scrollIntoView({ block: "center", behavior: "instant" }), selector);
    return page.$(selector);
}

// Moves the mouse over a chart, as a reader who looks for a point, until a tooltip shows.
export async function hover(page, chart) {
    const box = await (await chart.$("canvas")).boundingBox();
    for (let y = box.y + 20; y < box.y + Math.min(box.height, 320); y += 13) {
        for (let x = box.x + 60; x < box.x + box.width - 10; x += 13) {
            await page.mouse.move(x, y);
            const shown = await page.evaluate(() => document.querySelector("#vg-tooltip-element.visible")?.innerText ?? "");
            if (shown) return shown;
        }
    }
    return "";
}
