// The page as a reader meets it, in a headless Chromium.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { drawn, hover, launch, openPage, writePage } from "./browser.js";
import { failed, record, report, run } from "./fixtures.js";

let browser;
let html;
before(async () => {
    browser = await launch();
    html = writePage(report());
});
after(() => browser?.close());

const text = (page, selector) => page.$eval(selector, element => element.textContent);
const texts = (page, selector) => page.$$eval(selector, all => all.map(element => element.textContent));
const overflow = page => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

async function drawEverything(page) {
    const charts = await page.$$(".chart");
    for (const chart of charts) {
        await chart.evaluate(element => element.scrollIntoView({ block: "center", behavior: "instant" }));
        await page.waitForFunction(element => element.dataset.drawn !== undefined, { timeout: 20000 }, chart);
    }
    return charts.length;
}

test("loads without an error, a warning or a request, and draws all charts", async () => {
    const { page, complaints, requests } = await openPage(browser, html);
    assert.equal(await drawEverything(page), 7);
    assert.deepEqual(complaints, []);
    assert.equal(requests.length, 1, requests.join(" "));
    assert.ok(requests[0].startsWith("file://"));
    assert.deepEqual(await texts(page, "h2"), ["Cases by devices", "What errors are made of", "Speed against accuracy", "Where methods fail", "Every float", "Devices and their fingerprints"]);
    await page.close();
});

test("a page that asks for something is not let", async () => {
    const { page, complaints } = await openPage(browser, html);
    const answer = await page.evaluate(() => fetch("data:text/plain,x").then(() => "came", () => "refused"));
    assert.equal(answer, "refused");
    assert.notDeepEqual(complaints, []);
    await page.close();
});

test("a point of a chart answers to hover with its settings", async () => {
    const { page } = await openPage(browser, html);
    const shown = await hover(page, await drawn(page, "#charts article .chart"));
    assert.match(shown, /method/);
    assert.match(shown, /LINEAR=|sphere tracing/);
    assert.match(shown, /worst · 99.9 % · rms/);
    assert.match(shown, /ns \(/);
    await page.close();
});

test("a cell of a map answers to hover with its inputs and error", async () => {
    const { page } = await openPage(browser, html);
    const shown = await hover(page, await drawn(page, "#maps .chart"));
    assert.match(shown, /cos_theta_i=.*, n2=/);
    assert.match(shown, /condition number/);
    assert.match(shown, /theory/);
    await page.close();
});

test("the selectors of a chart draw it anew", async () => {
    const { page, complaints } = await openPage(browser, html);
    await drawn(page, "#charts article .chart");
    const [scene, error, cost] = await page.$$("#charts article:first-of-type select");
    await scene.select("steps");
    await error.select("rms");
    await cost.select("fetches");
    await drawn(page, "#charts article .chart");
    assert.match(await text(page, "#charts article"), /walls/);
    assert.match(await hover(page, await page.$("#charts article .chart")), /image reads/);
    assert.deepEqual(complaints, []);
    await page.close();
});

test("a map's panels are drawn", async () => {
    const { page, complaints } = await openPage(browser, html);
    for (const panel of ["condition", "disagreement", "error"]) {
        await (await page.$("#maps select")).select(panel);
        await drawn(page, "#maps .chart");
    }
    assert.deepEqual(complaints, []);
    assert.match(await text(page, "#maps"), /of 1,500 cells where theory says that it fails, 1,497 do/);
    await page.close();
});

test("the filter filters by case, device and verdict", async () => {
    const { page } = await openPage(browser, html);
    const filter = async words => {
        await page.$eval("input[type=search]", (input, value) => { input.value = value; input.dispatchEvent(new Event("input")); }, words);
        return text(page, "[role=status]");
    };
    assert.match(await filter(""), /^60 cases, 120 of 120 records on 2 devices/);
    assert.match(await filter("fail"), /^2 cases, 4 of 120 records/);
    assert.deepEqual(await texts(page, ".matrix tr.case th"), ["case_00003", "case_00053"]);
    assert.match(await filter("fail softpipe"), /^2 cases, 2 of 120 records on 1 devices/);
    assert.deepEqual(await texts(page, ".matrix thead th"), ["case", "osmesa:\u200bsoftpipe"]);
    assert.match(await filter("case_00003"), /^1 cases, 2 of/);
    assert.match(await filter("topic3/ -fail"), /^8 cases/);
    assert.match(await filter("nothing at all"), /^0 cases/);
    await page.close();
});

test("a row opens its worst inputs by the keyboard", async () => {
    const { page } = await openPage(browser, html);
    await page.type("input[type=search]", "case_00003");
    await page.focus(".matrix tr.case button");
    await page.keyboard.press("Enter");
    const details = await text(page, ".matrix tr.details");
    assert.match(details, /✗ fail vulkan:llvmpipe/);
    assert.match(details, /cos_i=0.25/);
    assert.match(details, /etalon run topic3\/group3\/case_00003 --device vulkan:llvmpipe --recipe spirv --at n1=0x1p\+0/);
    assert.match(details, /rounding/);
    assert.equal(await page.$eval(".matrix tr.case button", button => button.getAttribute("aria-expanded")), "true");
    await page.keyboard.press("Enter");
    assert.equal(await page.$(".matrix tr.details"), null);
    await page.close();
});

test("a command is copied by its button", async () => {
    const { page } = await openPage(browser, html);
    await page.evaluate(() => { document.execCommand = () => { window.copied = document.activeElement.value; return true; }; Object.defineProperty(navigator, "clipboard", { value: { writeText: () => Promise.reject(new Error("no")) } }); });
    await drawEverything(page);  // what is drawn above it would move it away from the mouse
    await page.click("#maps > article > .command button");
    await page.waitForFunction(() => window.copied, { timeout: 5000 });
    assert.equal(await page.evaluate(() => window.copied), "etalon map optics/snell/refract --over cos_theta_i,n2 --size 96x64 --at n1=1.6");
    await page.close();
});

test("ten thousand rows stay usable", async context => {
    const data = run(10000);
    const last = data.records.map(each => each.case).sort().at(-1);
    const many = writePage({ ...report(0), run: data, charts: {}, maps: {}, sweeps: {} });
    const started = Date.now();
    const { page, complaints } = await openPage(browser, many);
    await page.waitForSelector(".matrix tbody tr");
    const loaded = Date.now() - started;
    const timed = words => page.evaluate(value => {
        const input = document.querySelector("input[type=search]");
        const begin = performance.now();
        input.value = value;
        input.dispatchEvent(new Event("input"));
        document.querySelector(".matrix").getBoundingClientRect();  // lays it out
        return performance.now() - begin;
    }, words);
    const times = [];
    for (const words of ["c", "ca", "case_0", "fail", "softpipe pass", "-known", "case_09999", ""]) times.push(await timed(words));
    const unfolded = await page.evaluate(() => {
        const begin = performance.now();
        [...document.querySelectorAll("button")].find(button => button.textContent === "Unfold all").click();
        document.querySelector(".matrix").getBoundingClientRect();
        return performance.now() - begin;
    });
    assert.equal(await page.$eval(".matrix", table => Number(table.getAttribute("aria-rowcount")) > 10000), true);
    // Down to the end, where the last rows must stand.
    await page.$eval(".scroll.tall", scroller => { scroller.scrollTop = scroller.scrollHeight; });
    await page.waitForFunction(path => [...document.querySelectorAll(".matrix tr.case button")].some(each => each.title === path), { timeout: 5000 }, last);
    const rows = await page.$$eval(".matrix tr.case", all => all.length);
    assert.ok(rows < 600, `${rows} rows hold elements`);
    context.diagnostic(`loaded in ${loaded} ms, filtered in ${times.map(Math.round).join(", ")} ms, unfolded in ${Math.round(unfolded)} ms, ${rows} rows hold elements`);
    assert.deepEqual(complaints, []);
    // Twenty times what it takes: a machine under load is no failure, a filter that builds all rows is.
    assert.ok(Math.max(...times, unfolded) < 1500, times.join(", "));
    await page.close();
});

for (const width of [360, 700]) {
    test(`a window of ${width} px scrolls tables inside themselves only`, async () => {
        const { page } = await openPage(browser, html, { width });
        await drawEverything(page);
        assert.equal(await overflow(page), 0);
        await page.click(".matrix tr.case button");
        await page.evaluate(() => { for (const details of document.querySelectorAll("details")) details.open = true; });
        assert.equal(await overflow(page), 0);
        await page.close();
    });
}

test("print shows everything, and the screen is as it was afterwards", async () => {
    const many = writePage({ ...report(), run: run(200) });
    const { page, complaints } = await openPage(browser, many);
    const folded = await page.$$eval(".matrix tr.case", all => all.length);
    assert.equal(folded, 0);
    await page.emulateMediaType("print");
    await page.waitForFunction(() => [...document.querySelectorAll(".chart")].every(chart => chart.dataset.drawn !== undefined), { timeout: 20000 });
    assert.equal(await page.$$eval(".matrix tr.case", all => all.length), 200);
    assert.equal(await page.$$eval("main details:not([open])", all => all.length), 0);
    assert.equal(await page.$eval(".controls", controls => getComputedStyle(controls).display), "none");
    assert.ok(await page.$$eval(".matrix tr.details", all => all.length) >= 4, "failed cases tell their worst inputs");
    assert.equal(await page.$eval(".scroll.tall", scroller => scroller.scrollHeight - scroller.clientHeight), 0);
    await page.emulateMediaType("screen");
    await page.waitForFunction(() => document.querySelectorAll(".matrix tr.case").length === 0, { timeout: 5000 });
    const pdf = await page.pdf({ format: "a4" });
    assert.ok(pdf.length > 100000);
    assert.deepEqual(complaints, []);
    await page.close();
});

test("names that look like markup stay text", async () => {
    const evil = "</script><script>window.broken = 1</script><img src=x onerror=window.broken=1>";
    const json = report(4);
    json.run.records.push(failed(`a/${evil}`, "vulkan:llvmpipe"), record("b/<!--", "vulkan:llvmpipe", { reason: evil }));
    json.charts["relief/search"].points.forEach(point => { point.label = evil; });
    json.charts["relief/search"].description = evil;
    const { page, complaints } = await openPage(browser, writePage(json));
    await page.type("input[type=search]", "broken");
    await page.click(".matrix tr.case button");
    assert.match(await text(page, "#charts"), /<\/script><script>/);
    assert.match(await hover(page, await drawn(page, "#charts article .chart")), /onerror/);
    assert.equal(await page.evaluate(() => window.broken), undefined);
    assert.deepEqual(complaints, []);
    await page.close();
});

test("an empty report and a report of one command load", async () => {
    const none = { format: "etalon report 1", version: "1", processor: "p", sweeps: {}, charts: {}, maps: {} };
    for (const json of [none, { ...none, run: { ...run(0), records: [], devices: [] } }, { ...none, maps: report(0).maps }, { ...none, charts: report(0).charts }]) {
        const { page, complaints } = await openPage(browser, writePage(json));
        await drawEverything(page);
        assert.deepEqual(complaints, []);
        await page.close();
    }
});

test("what cannot be shown leaves all else", async () => {
    const json = report(4);
    json.maps = { "another/map": { case: "c" }, ...json.maps };
    json.sweeps = { "another/sweep": {} };
    const { page, complaints } = await openPage(browser, writePage(json));
    assert.match(await text(page, "#maps article"), /another\/map.*cannot be shown/);
    assert.match(await text(page, "#sweeps article"), /cannot be shown/);
    await drawn(page, "#maps article:nth-of-type(2) .chart");
    assert.deepEqual(complaints, []);
    await page.close();
});

test("signs and words tell verdicts apart without colour", async () => {
    const { page } = await openPage(browser, html);
    for (const [word, sign] of [["fail", "✗"], ["known", "◇"], ["skip", "–"], ["pass", "✓"]]) {
        await page.$eval("input[type=search]", (input, value) => { input.value = value; input.dispatchEvent(new Event("input")); }, word);
        const cell = await text(page, `.matrix td.verdict.${word}`);
        assert.ok(cell.startsWith(sign), cell);
    }
    await page.close();
});
