// Reports that the program itself writes, and its pictures.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import vm from "node:vm";
import { drawn, hover, launch, openPage, writePage } from "./browser.js";
import { report } from "./fixtures.js";
import { faults } from "./schema.js";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const folder = mkdtempSync(join(tmpdir(), "etalon-report-"));
const etalon = (words, environment = {}) => spawnSync(process.env.ETALON_PROGRAM, words, { encoding: "utf8", env: { ...process.env, ...environment } });
const read = name => readFileSync(join(folder, name), "utf8");

// That a browser takes it for a picture, and its words.
async function wordsOf(svg) {
    const page = await browser.newPage();
    const words = await page.evaluate(text => {
        const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
        return parsed.querySelector("parsererror") ? "no picture" : [...parsed.querySelectorAll("text")].map(each => each.textContent).join(" | ");
    }, svg);
    await page.close();
    return words;
}

test("run and sweep make one valid report and its page", async () => {
    const ran = etalon(["run", "lens", "--root", "tests/readme", "--device", "cpu", "--report", folder, "--svg"]);
    assert.equal(ran.status, 1, ran.stderr);  // one of the two is meant to fail
    const swept = etalon(["sweep", "lens/sagitta_stable", "--root", "tests/readme", "--exhaustive", "--at", "radius=50", "--from", "19.9", "--device", "cpu", "--journal", "/dev/null", "--report", folder, "--svg"]);
    assert.equal(swept.status, 0, swept.stderr);
    const json = JSON.parse(read("report.json"));
    assert.deepEqual(faults(json), []);
    assert.deepEqual(faults(JSON.parse(JSON.stringify({ ...json, run: { ...json.run, devices: [{}] } }))).length > 0, true);
    assert.equal(json.run.records.length > 0, true);
    assert.deepEqual(Object.keys(json.sweeps), ["lens/sagitta_stable over aperture=19.9..20 at radius=50 on cpu (spirv)"]);
    assert.deepEqual(readdirSync(folder).filter(name => !name.endsWith(".svg")).sort(), ["index.html", "report.json", "report.schema.json"]);
    const { page, complaints, requests } = await openPage(browser, join(folder, "index.html"));
    assert.match(await page.$eval("#run", section => section.textContent), /✗ fail/);
    assert.match(await page.$eval("#sweeps", section => section.textContent), /etalon run lens\/sagitta_stable .*--at radius=0x1.9p\+5,aperture=/);
    assert.deepEqual(complaints, []);
    assert.equal(requests.length, 1);
    await page.close();
    assert.match(await wordsOf(read("budget.svg")), /lens\/sagitta/);
    assert.match(await wordsOf(read("sweep-lens-sagitta_stable-over-aperture=19.9..20-at-radius=50-on-cpu-spirv-.svg")), /error in ulp/);
});

// A family and a map of two lines of GLSL, and all that a reader does with their pictures.
test("a chart and a map that the program made are drawn and answer to hover", async () => {
    const root = mkdtempSync(join(tmpdir(), "etalon-root-"));
    const own = mkdtempSync(join(tmpdir(), "etalon-report-"));
    mkdirSync(join(root, "cases"));
    writeFileSync(join(root, "f.glsl"), "float quick(float a, float b) { return a; }\nfloat exact(float a, float b) { return sin(a) + b; }\nfloat half_way(float a, float b) { return a < 0.5 ? a + b : 0.0 / b; }\n");
    const domain = "[domain]\na = { range = [0.0, 1.0], sample = \"linear\", count = 9 }\nb = { range = [0.0, 1.0], sample = \"linear\", count = 9 }\n";
    writeFileSync(join(root, "cases", "sum.family.toml"), `quantity = "a </script> sum"\ndescription = "é \\"two\\" ways"\nmeasure = "absolute"\nsource = "f.glsl"\noracle = "sin(a) + b"\n${domain}[[member]]\nname = "quick"\ncall = "quick(a, b)"\n[[member]]\nname = "exact"\ncall = "exact(a, b)"\n`);
    writeFileSync(join(root, "cases", "sum.toml"), `source = "f.glsl"\ncall = "half_way(a, b)"\noracle = "a + b"\naccept = { absolute = 1e-6 }\n${domain}[map]\nover = ["a", "b"]\nsize = [12, 10]\nfails = "a > 0.5"\nsafe = "a < 0.5"\nbecause = "above a half </script> nothing is added"\n`);
    const common = ["--root", root, "--device", "cpu", "--report", own, "--svg"];
    for (const words of [["chart", "sum"], ["map", "sum"], ["map", "sum", "--range", "b=1:2", "--size", "400x330"]]) {
        const finished = etalon([...words, ...common]);
        assert.equal(finished.status, 0, finished.stderr);
    }
    const json = JSON.parse(readFileSync(join(own, "report.json"), "utf8"));
    assert.deepEqual(faults(json), []);
    assert.deepEqual(Object.keys(json.maps), ["sum over a,b", "sum over a,b in b=1:2"]);
    const { page, complaints } = await openPage(browser, join(own, "index.html"));
    const point = await hover(page, await drawn(page, "#charts article .chart"));
    assert.match(point, /quick|exact/);
    assert.match(point, / ns \(/);
    const cell = await hover(page, await drawn(page, "#maps article .chart"));
    assert.match(cell, /a=0\.\d+, b=0\.\d+/);
    assert.match(cell, /theory/);
    const maps = await page.$eval("#maps", section => section.textContent);
    assert.match(maps, /✓ agrees on cpu: of 60 cells where theory says that it fails, 60 do/);
    assert.match(maps, /Each cell that is drawn is the worst of 2×2\./);
    await drawn(page, "#maps article:nth-of-type(2) .chart");
    assert.deepEqual(complaints, []);
    await page.close();
    assert.deepEqual(readdirSync(own).filter(name => name.endsWith(".svg")).sort(), [
        "chart-sum-counts.svg", "chart-sum-time.svg", "map-sum-over-a-b-condition.svg", "map-sum-over-a-b-in-b=1-2-condition.svg", "map-sum-over-a-b-in-b=1-2.svg", "map-sum-over-a-b.svg"]);
    assert.match(await wordsOf(readFileSync(join(own, "map-sum-over-a-b-in-b=1-2.svg"), "utf8")), /each cell is the worst of 2×2/);
});

// More cells than a call of a function may have arguments, of which one failed.
test("the largest map is drawn, and its one failure seen", async () => {
    const json = report(0);
    const [key, map] = Object.entries(json.maps)[0];
    const axis = name => ({ name, scale: "linear", edges: Array.from({ length: 1025 }, (_, index) => index), values: Array.from({ length: 1024 }, (_, index) => index + 0.5) });
    const cells = value => new Array(1024 * 1024).fill(value);
    const device = { ...map.devices[0], error: cells(1), mark: cells(map.marks.indexOf("holds")) };
    device.mark[1000 * 1024 + 1001] = map.marks.indexOf("missed");
    json.maps = { [key]: { ...map, x: axis("x"), y: axis("y"), devices: [device], condition: cells(2), disagreement: null, prediction: null } };
    const { page, complaints } = await openPage(browser, writePage(json));
    await drawn(page, "#maps .chart");
    assert.match(await page.$eval("#maps", section => section.textContent), /missed: .*Each cell that is drawn is the worst of 4×4\./);
    assert.deepEqual(complaints, []);
    await page.close();
});

test("a report that is not ours, or --svg without node, ends before any work", () => {
    const kept = read("report.json");
    writeFileSync(join(folder, "report.json"), kept.slice(0, 1000));
    const cut = etalon(["run", "lens", "--root", "tests/readme", "--device", "cpu", "--report", folder]);
    assert.equal(cut.status, 2);
    assert.equal(cut.stdout, "");
    assert.equal(cut.stderr.trim().split("\n").length, 1);
    assert.match(cut.stderr, /--report: .*report.json: is no report: it is cut/);
    assert.equal(read("report.json"), kept.slice(0, 1000));
    const none = join(folder, "none");
    const without = etalon(["sweep", "lens/sagitta_stable", "--root", "tests/readme", "--exhaustive", "--report", none, "--svg"], { PATH: folder });
    assert.equal(without.status, 2);
    assert.match(without.stderr, /^etalon: --svg: the program 'node' is needed for pictures: .*\n$/);
    assert.equal(existsSync(join(none, "report.json")), false);
    assert.equal(etalon(["run", "lens", "--root", "tests/readme", "--svg"]).status, 2);
});

test("charts and maps are pictures too", async () => {
    const context = vm.createContext({ console, structuredClone, setTimeout, clearTimeout, URL });
    vm.runInContext(readFileSync(process.env.ETALON_PAGE_SCRIPT, "utf8"), context);
    const { charts, maps } = report(0);
    const search = await context.Etalon.pictures("charts", "relief/search", charts["relief/search"]);
    assert.equal(Object.keys(search).length, 9);
    const words = await wordsOf(search["chart-relief-search-all-time.svg"]);
    assert.match(words, /way to the first intersection/);
    assert.match(words, /linear \+ binary, LINEAR=/);
    assert.match(words, /% of rays/);
    assert.match(words, /osmesa:softpipe/);
    const costs = await context.Etalon.pictures("charts", "thesis/table_1", charts["thesis/table_1"]);
    assert.match(await wordsOf(costs["chart-thesis-table_1-ratio.svg"]), /published/);
    const [key, map] = Object.entries(maps)[0];
    const drawn = await context.Etalon.pictures("maps", key, map);
    assert.deepEqual(Object.keys(drawn), ["", "-condition", "-disagreement"].map(end => `map-optics-snell-refract-over-cos_theta_i-n2${end}.svg`));
    assert.match(await wordsOf(Object.values(drawn)[0]), /theory: fails/);
    assert.ok(Object.values(drawn)[0].length < 1.2e6, `${Object.values(drawn)[0].length} bytes`);
});
