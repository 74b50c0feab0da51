// Numbers as report.json has them, and as people read them.

const kWords = { inf: Infinity, "-inf": -Infinity, nan: NaN };

// JSON has no infinities: they are words there.
export function number(value) {
    if (typeof value === "number") return value;
    return value in kWords ? kWords[value] : NaN;
}

// Three digits: "0", "3.21", "1.5e+7", "∞", "NaN".
export function short(value) {
    const x = number(value);
    if (Number.isNaN(x)) return "NaN";
    if (!Number.isFinite(x)) return x > 0 ? "∞" : "−∞";
    if (x === 0) return "0";
    const size = Math.abs(x);
    return size >= 1e5 || size < 1e-3
        ? String(Number(x.toPrecision(3)).toExponential())
        : String(Number(x.toPrecision(3)));
}

export function percent(share) {
    return short(100 * number(share)) + " %";
}

export function count(value) {
    return String(value).replace(/\B(?=(\d{3})+$)/g, ",");
}

// What a logarithmic axis shows of values among which may be 0 and infinities: `at(x)` is a place
// on it; zeros stand one decade below the least, infinities and NaN one above the greatest.
export class LogAxis {
    constructor(values) {
        const all = values.map(number);
        const positive = all.filter(x => x > 0 && Number.isFinite(x));
        const least = positive.length ? positive.reduce((a, b) => Math.min(a, b)) : 1;
        const greatest = positive.length ? positive.reduce((a, b) => Math.max(a, b)) : 1;
        this.hasZero = all.some(x => x <= 0);
        this.hasInfinity = all.some(x => x === Infinity || Number.isNaN(x));
        this.zero = 10 ** (Math.floor(Math.log10(least)) - 1);
        this.infinity = 10 ** (Math.ceil(Math.log10(greatest)) + 1);
        this.low = this.hasZero ? this.zero / 1.6 : least / 1.6;
        this.high = this.hasInfinity ? this.infinity * 1.6 : greatest * 1.6;
    }

    at(value) {
        const x = number(value);
        if (x <= 0) return this.zero;
        return Number.isFinite(x) ? x : this.infinity;
    }

    get domain() { return [this.low, this.high]; }

    // Powers of ten; of 1, 2 and 5 where the span is short.
    get ticks() {
        const first = Math.floor(Math.log10(this.low));
        const last = Math.ceil(Math.log10(this.high));
        const span = Math.log10(this.high / this.low);
        const steps = span < 2.5 ? [1, 2, 5] : [1];
        const stride = Math.max(1, Math.ceil(span / 9));
        const ticks = [];
        for (let power = first; power <= last; ++power) {
            if (stride > 1 && (power - first) % stride !== 0) continue;
            for (const step of steps) ticks.push(Number(`${step}e${power}`));
        }
        return ticks.filter(x => x >= this.low && x <= this.high && this.isWithin(x))
            .concat(this.hasZero ? [this.zero] : [], this.hasInfinity ? [this.infinity] : []);
    }

    isWithin(x) {
        return (!this.hasZero || x > this.zero * 1.01) && (!this.hasInfinity || x < this.infinity * 0.99);
    }

    // For Vega: the label of a tick.
    get labels() {
        const zero = this.hasZero ? `datum.value <= ${this.zero * 1.01} ? '0' : ` : "";
        const infinity = this.hasInfinity ? `datum.value >= ${this.infinity * 0.99} ? '∞' : ` : "";
        return `${zero}${infinity}format(datum.value, datum.value < 1e-3 || datum.value >= 1e5 ? '.0e' : '~r')`;
    }
}
