// Verdicts, as words and signs that need no colour.

import { number, percent, short } from "./numbers.js";

// From the best to the worst.
export const kVerdicts = [
    { word: "skip", sign: "–", says: "could not run here" },
    { word: "pass", sign: "✓", says: "within the tolerance" },
    { word: "known", sign: "◇", says: "fails as the case expects it to, with a cause" },
    { word: "nonconforming", sign: "≠", says: "within the tolerance, but outside what the specification allows" },
    { word: "fail", sign: "✗", says: "outside the tolerance" },
    { word: "timeout", sign: "⧖", says: "no answer in time" },
    { word: "crash", sign: "‼", says: "the driver crashed" },
];
const kRank = new Map(kVerdicts.map(({ word }, rank) => [word, rank]));

export const wordOf = record => (record.known_cause ? "known" : record.verdict);
export const rankOf = word => kRank.get(word) ?? kVerdicts.length - 1;
export const signOf = word => kVerdicts[rankOf(word)].sign;

// What of the tolerance was used: "25 %", "4.3e+4×", "" where nothing was judged.
export function usedText(record) {
    if (!record.worst) return "";
    const used = number(record.worst.used);
    return used <= 10 ? percent(used) : `${short(used)}×`;
}
