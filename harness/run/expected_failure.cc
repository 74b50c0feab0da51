#include "run/expected_failure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/file.h"
#include "base/format.h"

namespace etalon {
namespace {

std::string CauseText(const ExpectedFailure& expected) {
    return expected.status + ": " + expected.cause +
           (expected.link.empty() ? "" : " (" + expected.link + ")");
}

// Whether the expectation is about this output or law.
bool IsAbout(const ExpectedFailure& expected, const std::string& what) {
    return expected.law.empty() || GlobMatches("law '" + expected.law + "'", what);
}

double NumberOf(const Value& value) {
    return value.decimal == "true" ? 1 : std::strtod(value.hex.c_str(), nullptr);
}

// What was seen of the things that the expectation is about; nothing where none was judged.
std::optional<double> Seen(const ExpectedFailure& expected, Figure::Measure measure,
                           const std::vector<JudgedThing>& things) {
    const JudgedThing* worst = nullptr;
    std::uint64_t judged = 0;
    std::uint64_t refused = 0;
    for (const JudgedThing& thing : things) {
        if (!thing.worst || !IsAbout(expected, thing.what)) {
            continue;
        }
        judged += thing.judged;
        refused += thing.refused;
        if (worst == nullptr || thing.worst->used > worst->worst->used) {
            worst = &thing;
        }
    }
    if (worst == nullptr) {
        return std::nullopt;
    }
    switch (measure) {
        case Figure::Measure::kAbsolute:
            return worst->worst->error;
        case Figure::Measure::kRelative:
            return worst->worst->error / std::fabs(NumberOf(*worst->worst->expected));
        case Figure::Measure::kUlp:
            return worst->worst->ulp_error;
        case Figure::Measure::kValue:
            return NumberOf(worst->worst->actual);
        case Figure::Measure::kRefused:
            return static_cast<double>(refused) / static_cast<double>(judged);
    }
    return std::nullopt;
}

// True where the expectation has no figure, or that figure; the record keeps what was seen.
bool FigureAgrees(const ExpectedFailure& expected, const std::vector<JudgedThing>& things,
                  Record& record) {
    if (!expected.figure) {
        return true;
    }
    const std::optional<double> seen = Seen(expected, expected.figure->measure, things);
    const bool agrees = seen && expected.figure->Agrees(*seen);
    record.figures.push_back(
        {expected.figure->Text(), seen ? format("{:.7g}", *seen) : "no value", agrees});
    return agrees;
}

}  // namespace

void ApplyExpectations(const Case& source, Extent extent, const std::vector<JudgedThing>& things,
                       Record& record) {
    std::vector<ExpectedFailure> expected = source.expected_failures;
    std::erase_if(expected, [&](const ExpectedFailure& one) {
        return !GlobMatches(one.device, record.device) || !GlobMatches(one.recipe, record.recipe);
    });
    if (record.verdict == Verdict::kSkip || expected.empty()) {
        return;
    }
    if (record.verdict == Verdict::kPass) {
        if (extent != Extent::kSome) {
            record.verdict = Verdict::kFail;
            record.reason = "passes, but is expected to fail (" + CauseText(expected.front()) +
                            "); take the expectation out of the case";
        }
        return;
    }
    std::vector<std::string> open = record.failed;
    if (open.empty()) {
        open.emplace_back();  // a verdict without a value: a crash, a hang, a refused program
    }
    std::string causes;
    for (const ExpectedFailure& one : expected) {
        const auto is_about = [&one](const std::string& what) { return IsAbout(one, what); };
        if (one.verdict != VerdictName(record.verdict) ||
            std::none_of(open.begin(), open.end(), is_about)) {
            continue;
        }
        if (extent != Extent::kAll || FigureAgrees(one, things, record)) {
            std::erase_if(open, is_about);
            causes += (causes.empty() ? "" : "; ") + CauseText(one);
        }
    }
    if (open.empty()) {
        record.known_cause = causes;
        return;
    }
    for (const FigureSeen& figure : record.figures) {
        if (!figure.agrees) {
            record.reason +=
                format("{}expected figure {}, saw {}", record.reason.empty() ? "" : "; ",
                       figure.expected, figure.seen);
        }
    }
}

}  // namespace etalon
