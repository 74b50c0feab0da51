// Reports that the program itself writes, and its pictures.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import vm from "node:vm";
import { launch, openPage } from "./browser.js";
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
