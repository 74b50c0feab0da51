// Reports as the commands leave them, made up.

const hex = x => `${x}`;
export const value = x => ({ decimal: String(x), hex: hex(x) });

export const kDevices = ["vulkan:llvmpipe", "osmesa:softpipe"];

export const device = name => ({
    name, description: `${name} (LLVM 15.0.6, 256 bits)`, driver: "Mesa", version: "22.3.6", api: "Vulkan 1.3.230", glsl_version: 450, compiler: "LLVM 15.0.6",
    features: ["compute", "spirv"], float_controls: ["RoundingModeRTE"], fingerprint: "0123456789abcdef",
});

function observation(used) {
    return {
        output: "result", rule: "ulp 4", inputs: { n1: value(1), cos_i: value(0.25) }, actual: value(0.5), expected: value(0.5000001), error: 1e-7, ulp_error: 4 * used, used,
        budget: { culprit: used > 1 ? "rounding" : "", law: false, method: { ulp: 0.1, absolute: 1e-9 }, rounding: { ulp: 4 * used, absolute: 1e-7 }, driver: { ulp: 0, absolute: 0 } },
        allowed: { low: value(0.4), high: value(0.6), excess_ulp: 0 },
    };
}

// One record; `more` replaces parts of it.
export function record(path, deviceName, more = {}) {
    return {
        case: path, device: deviceName, recipe: "spirv", family: "", covers: ["F4"], verdict: "pass", reason: "", seed: 1, rows: 100, all_rows: 100, judged: 100, refused: 0,
        failed: [], repeat: `etalon run ${path} --device ${deviceName} --recipe spirv --at n1=0x1p+0,cos_i=0x1p-2`, known_cause: "", flake: "", seconds: 0.1, figures: [],
        specification: { profile: "vulkan-1.3", unevaluated: "", held: 100, unbounded: 0, void_bounds: 0, outside: 0, outside_in: [], unjudged: 0, worst_outside: null },
        culprits: {}, worst_parts: { method: { ulp: 0.1, absolute: 1e-9, output: "result", inputs: { n1: value(1) } }, rounding: { ulp: 3, absolute: 1e-7, output: "result", inputs: { n1: value(1) } } },
        worst: observation(0.25), ...more,
    };
}

export function failed(path, deviceName) {
    return record(path, deviceName, { verdict: "fail", refused: 3, failed: ["result"], culprits: { rounding: 3 }, worst: observation(1234) });
}

// `cases` cases, each on both devices.
export function run(cases) {
    const records = [];
    for (let index = 0; index < cases; ++index) {
        const path = `topic${index % 7}/group${index % 90}/case_${String(index).padStart(5, "0")}`;
        for (const name of kDevices) {
            if (index % 50 === 3) records.push(failed(path, name));
            else if (index % 50 === 4) records.push(record(path, name, { verdict: "fail", known_cause: "the published form cancels", refused: 3, worst: observation(90) }));
            else if (index % 50 === 5) records.push(record(path, name, { verdict: "skip", reason: "has no fragment stage", worst: null, specification: null, judged: 0 }));
            else records.push(record(path, name));
        }
    }
    return { version: "0.1.0", processor: "AMD EPYC", seconds: 94, devices: kDevices.map(device), absent: [{ name: "egl:zink", reason: "is not installed" }], records, findings: [] };
}

const accuracy = (worst, isSearch) => ({
    rows: 1000, judged: 1000, undecided: 0, worst, p999: worst / 2, rms: worst / 9, bits: worst > 0 ? Math.max(0, -Math.log2(worst)) : "inf", not_finite: 0,
    ...(isSearch ? { missed: Math.min(1, worst), wrong: worst / 3 } : {}), worst_inputs: [["x", value(0.25)]], repeat: "etalon run relief/search --at x=0x1p-2",
});

const cost = (nanoseconds, reference) => ({
    nanoseconds, low: nanoseconds * 0.95, high: nanoseconds * 1.07, ratio: nanoseconds / reference, ratio_low: 0.95 * nanoseconds / reference, ratio_high: 1.07 * nanoseconds / reference, rounds: 40, clock: "host clock",
});

const counts = total => {
    const each = { arithmetic: 0.5 * total, division: 1, special: 2, comparison: 0.1 * total, integer: 0.2 * total, fetch: Math.round(total / 12), other: 0, total };
    return { mean: each, worst: each };
};

// A search over scenes, with dominated members, an exact one and one that could not run.
export function search() {
    const points = [];
    for (const name of kDevices) {
        const slow = name === kDevices[0] ? 1 : 22;
        for (const [index, scene] of ["sine, 4 periods", "steps", "all"].entries()) {
            for (const steps of [8, 16, 32, 64]) {
                points.push(point("linear", { LINEAR: steps }, 2 * steps * slow, 0.5 / steps, steps * 12, true));
                for (const binary of [4, 6]) points.push(point("linear + binary", { LINEAR: steps, BINARY: binary }, (2 * steps + 2.6 * binary) * slow, 0.5 / steps / 2 ** binary, (steps + binary) * 12, true));
                points.push(point("secant", { LINEAR: steps }, (2.1 * steps + 14) * slow, 0.9 / steps, (steps + 3) * 12, true));
            }
            points.push(point("sphere tracing", {}, 75 * slow, 0, 300, true));
            points.push({ ...point("cone stepping", {}, 1, 1, 1, true), accuracy: null, cost: null, counts: null, reason: "the device has no images" });
            function point(member, settings, nanoseconds, worst, operations, isSearch) {
                const label = [member, ...Object.entries(settings).map(([key, number]) => `${key}=${number}`)].join(", ");
                return { member, description: `${member}, as published`, settings, label, scene, device: name, recipe: "spirv", reason: "", accuracy: accuracy(worst * (1 + index), isSearch), cost: cost(nanoseconds, 32 * slow), counts: counts(operations), front: false };
            }
        }
    }
    for (const each of points) {
        if (each.reason) continue;
        each.front = !points.some(other => !other.reason && other.device === each.device && other.scene === each.scene && other.cost.nanoseconds <= each.cost.nanoseconds && other.accuracy.worst <= each.accuracy.worst &&
            (other.cost.nanoseconds < each.cost.nanoseconds || other.accuracy.worst < each.accuracy.worst));
    }
    const bounds = [];
    for (const name of kDevices) {
        for (const [bound, text] of [[1, "1"], [0.25, "1/4"], [1 / 255, "1/255"], [1e-3, "1e-3"], [1e-6, "1e-6"]]) {
            for (const by of ["worst", "p999"]) {
                const holding = points.filter(each => each.device === name && each.scene === "all" && each.accuracy && each.accuracy[by] <= bound).sort((a, b) => a.cost.nanoseconds - b.cost.nanoseconds);
                bounds.push({ device: name, scene: "all", bound, text, by, point: holding.length ? points.indexOf(holding[0]) : null });
            }
        }
    }
    return {
        family: "relief/search", quantity: "way to the first intersection", description: "Searches of a height field along a ray.", measure: "absolute", unit: "texels", search: true, reference: "linear 16",
        scenes: [{ name: "sine, 4 periods", description: "a smooth surface" }, { name: "steps", description: "walls" }], devices: kDevices.map(device), points, bounds,
    };
}

// A family without truths: costs, some published.
export function costs() {
    const rows = [["parallax", 1, 22.8], ["+ shadows", 1.7, 40.1], ["+ refraction", 2.9, 61], ["+ blur", 4.4, null]];
    return {
        family: "thesis/table_1", quantity: "cumulative techniques", description: "Full-screen shading.", measure: "absolute", unit: "", search: false, reference: "parallax", published_unit: "ms, GeForce 7600GS, 800x600", scenes: [{ name: "", description: "" }], devices: [device(kDevices[0])],
        points: rows.map(([member, ratio, published]) => ({
            member, description: member, settings: {}, label: member, scene: "", device: kDevices[0], recipe: "spirv", reason: "", accuracy: null, cost: cost(ratio * 40, 40), counts: counts(ratio * 100),
            ...(published ? { published, published_ratio: published / 22.8 } : {}), front: false,
        })), bounds: [],
    };
}

// Every mark, a theory and all panels.
export function map() {
    const marks = ["holds", "refused", "missed", "wrong", "nan", "infinity", "spent", "undecided", "crash"];
    const [width, height] = [96, 64];
    const log = Array.from({ length: width + 1 }, (_, index) => 10 ** (-6 + 6 * index / width));
    const linear = Array.from({ length: height + 1 }, (_, index) => 1 + 2 * index / height);
    const middles = edges => edges.slice(1).map((edge, index) => (edge + edges[index]) / 2);
    const [xs, ys] = [middles(log), middles(linear)];
    const shown = name => {
        const error = [];
        const mark = [];
        for (let iy = 0; iy < height; ++iy) {
            for (let ix = 0; ix < width; ++ix) {
                const [x, y] = [xs[ix], ys[iy]];
                const size = 1e-7 * y / x;
                const word = x < 2e-6 ? "nan" : x < 5e-6 ? "infinity" : x < 1.2e-5 && y > 2 ? "crash" : x < 3e-5 * y ? "missed" : x < 8e-5 * y ? "wrong" : x < 2e-4 ? "spent" : size > 1e-5 ? "refused" : iy === 40 && ix > 70 ? "undecided" : "holds";
                error.push(word === "nan" ? "nan" : word === "infinity" ? "inf" : iy < 3 && ix > 80 ? 0 : size);
                mark.push(marks.indexOf(word));
            }
        }
        return { device: name, recipe: "spirv", driver: "Mesa 22.3.6", reason: "", error, mark, worst: observation(90) };
    };
    const cells = Array.from({ length: width * height }, (_, cell) => (xs[cell % width] < 9e-5 * ys[Math.floor(cell / width)] ? 2 : xs[cell % width] > 2e-2 ? 1 : 0));
    return {
        case: "optics/snell/refract", description: "Refraction near the critical angle.", output: "result", measure: "absolute", tolerance: "absolute 1e-05", x: { name: "cos_theta_i", scale: "log", edges: log, values: xs },
        y: { name: "n2", scale: "linear", edges: linear, values: ys }, fixed: "n1=1.6", search: true, marks, devices: [...kDevices.map(shown), { device: "cpu", recipe: "spirv", driver: "", reason: "has no fragment stage", error: [], mark: [], worst: null }],
        condition: cells.map((_, cell) => 1 / xs[cell % width]), disagreement: cells.map((_, cell) => (cell % 9 ? 1e-7 * xs[cell % width] : 0)),
        prediction: { fails: "cos_theta_i < 9e-5 * n2", safe: "cos_theta_i > 2e-2", because: "The square root loses what is below its step.", cells, agreement: kDevices.map(name => ({ device: name, safe: 2000, safe_held: 2000, fails: 1500, failed: 1497 })) },
        repeat: "etalon map optics/snell/refract --over cos_theta_i,n2 --size 96x64 --at n1=1.6",
    };
}

export function sweep() {
    const bins = [[0, 1e6], ...Array.from({ length: 12 }, (_, index) => [2 ** (index - 6), Math.round(1e7 / (1 + (index - 5) ** 4))])].map(([up_to_ulp, count]) => ({ up_to_ulp, is_finite: true, count }));
    return {
        case: "lens/sagitta", device: kDevices[0], driver: "Mesa 22.3.6", fingerprint: "0123456789abcdef", recipe: "spirv", input: "aperture", from: value(16), to: value(20), fixed: "radius=50", settings: 1, floats: 2097153, laws_not_held: 0, shard: "",
        rows: 2097153, all_rows: 2097153, verdict: "pass", reason: "",
        outputs: [{ output: "result", rule: "ulp 4", judged: 2097153, refused: 0, worst_ulp: seen(2.43), worst_used: seen(2.43), first_refused: null, histogram: [...bins, { up_to_ulp: "inf", is_finite: true, count: 0 }, { up_to_ulp: "inf", is_finite: false, count: 0 }] }],
    };
    function seen(ulp) {
        const { inputs, actual, expected, error, used } = observation(0.6);
        return { inputs, actual, expected, error, ulp_error: ulp, used, repeat: "etalon run lens/sagitta --device vulkan:llvmpipe --recipe spirv --at radius=0x1.9p+5,aperture=0x1.36e02cp+4" };
    }
}

export function report(cases = 60) {
    return {
        format: "etalon report 1", version: "0.1.0", processor: "AMD EPYC", run: run(cases), sweeps: { "lens/sagitta over aperture": sweep() },
        charts: { "relief/search": search(), "thesis/table_1": costs() }, maps: { "optics/snell/refract over cos_theta_i,n2": map() },
    };
}
