// report.json against its schema.

import assert from "node:assert/strict";
import { test } from "node:test";
import { faults } from "./schema.js";
import { report } from "./fixtures.js";

const whole = () => structuredClone(report(8));

test("a whole report is valid", () => assert.deepEqual(faults(whole()), []));

test("a report of one command is valid", () => {
    const json = { ...whole(), sweeps: {}, charts: {}, maps: {} };
    assert.deepEqual(faults(json), []);
    delete json.run;
    assert.deepEqual(faults(json), []);
});

test("numbers that JSON lacks are valid, other words are not", () => {
    const json = whole();
    json.run.records[0].worst.error = "nan";
    assert.deepEqual(faults(json), []);
    json.run.records[0].worst.error = "large";
    assert.notDeepEqual(faults(json), []);
});

for (const [name, spoil] of Object.entries({
    "another format": json => { json.format = "etalon report 2"; },
    "no charts": json => { delete json.charts; },
    "an unknown section": json => { json.extra = {}; },
    "a record without a verdict": json => { delete json.run.records[3].verdict; },
    "an unknown verdict": json => { json.run.records[3].verdict = "perhaps"; },
    "a share above one": json => { json.charts["relief/search"].points[0].accuracy.missed = 1.5; },
    "a point without a label": json => { delete json.charts["relief/search"].points[0].label; },
    "a cell that is no number": json => { json.maps["optics/snell/refract over cos_theta_i,n2"].devices[0].error[7] = null; },
    "a prediction of 3": json => { json.maps["optics/snell/refract over cos_theta_i,n2"].prediction.cells[7] = 3; },
    "a histogram of text": json => { json.sweeps["lens/sagitta over aperture"].outputs[0].histogram[0].count = "12"; },
})) {
    test(`${name} is not valid`, () => {
        const json = whole();
        spoil(json);
        assert.notDeepEqual(faults(json), []);
    });
}
