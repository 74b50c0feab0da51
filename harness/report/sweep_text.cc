#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "report/sweep_record.h"
#include "report/text.h"

namespace etalon {
namespace {

std::string InputsText(const Observation& seen, const std::string& separator, bool hexadecimal) {
    std::string text;
    for (const auto& [name, value] : seen.inputs) {
        text += (text.empty() ? "" : separator) + name + "=" +
                (hexadecimal ? value.hex : value.decimal);
    }
    return text;
}

std::string UsedText(const Observation& seen) {
    return seen.used > 1 ? ShortNumber(seen.used) + " times the tolerance"
                         : ShortNumber(100 * seen.used) + " % of the tolerance";
}

std::string SeenText(const std::string& what, const Observation& seen, const SweepRecord& sweep) {
    return format(
        "  {:9} {} ulp, {} absolute, {}\n"
        "    input     {}\n"
        "              {}\n"
        "    actual    {} = {}\n"
        "    expected  {} = {}\n"
        "    repeat    {} --at {}\n",
        what, ShortNumber(seen.ulp_error), ShortNumber(seen.error), UsedText(seen),
        InputsText(seen, ", ", false), InputsText(seen, ", ", true), seen.actual.decimal,
        seen.actual.hex, seen.expected->decimal, seen.expected->hex, sweep.repeat,
        InputsText(seen, ",", true));
}

bool IsSameInput(const Observation& a, const Observation& b) {
    return InputsText(a, ",", true) == InputsText(b, ",", true);
}

std::string BoundText(double upper) {
    return upper < 1 ? format("1/{}", 1 / upper) : format("{}", upper);
}

constexpr double kBar = 40;  // characters that stand for all values

// From the first to the last bin that holds something.
std::string HistogramText(const SweptOutput& output) {
    const auto& bins = output.histogram;
    std::size_t first = bins.size();
    std::size_t last = 0;
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        if (bins[bin].count > 0) {
            first = std::min(first, bin);
            last = bin;
        }
    }
    std::string text = "  errors in ulp\n";
    for (std::size_t bin = first; bin <= last && bin < bins.size(); ++bin) {
        const std::string bound = bin == 0                 ? "0"
                                  : bin + 1 == bins.size() ? "infinite"
                                  : std::isinf(bins[bin].upper)
                                      ? "above " + BoundText(bins[bin - 1].upper)
                                      : "up to " + BoundText(bins[bin].upper);
        const double share =
            static_cast<double>(bins[bin].count) / static_cast<double>(output.judged);
        const std::string bar(static_cast<std::size_t>(std::lround(kBar * share)), '#');
        text += format("    {:14} {:>14}  {:>8.4f} %{}\n", bound, bins[bin].count, 100 * share,
                       bar.empty() ? "" : "  " + bar);
    }
    return text;
}

std::string OutputText(const SweptOutput& output, const SweepRecord& sweep) {
    std::string text = format("\n{}, by {}: {} of {} values refused\n", output.name, output.rule,
                              output.refused, output.judged);
    if (output.judged == 0) {
        return text;
    }
    if (output.worst_ulp) {
        text += SeenText("worst", *output.worst_ulp, sweep);
    } else if (!output.worst_used) {
        text += "  worst     0 ulp: every value is exact\n";
    }
    if (output.worst_used &&
        !(output.worst_ulp && IsSameInput(*output.worst_used, *output.worst_ulp))) {
        text += SeenText("most used", *output.worst_used, sweep);
    }
    if (output.first_refused &&
        !(output.worst_ulp && IsSameInput(*output.first_refused, *output.worst_ulp)) &&
        !(output.worst_used && IsSameInput(*output.first_refused, *output.worst_used))) {
        text += SeenText("first", *output.first_refused, sweep);
    }
    return text + HistogramText(output);
}

}  // namespace

std::string SweepText(const SweepRecord& sweep) {
    std::string text = format("{} on {} ({}): {}\n", sweep.case_path, sweep.device, sweep.recipe,
                              VerdictName(sweep.verdict));
    if (!sweep.reason.empty()) {
        text += "  reason    " + sweep.reason + "\n";
    }
    text += format("  swept     {}, every float from {} to {}: {}{}\n", sweep.input,
                   sweep.from.decimal, sweep.to.decimal, sweep.floats,
                   sweep.settings > 1 ? format(", {} times", sweep.settings) : "");
    if (!sweep.fixed.empty()) {
        text += "  others    " + sweep.fixed + "\n";
    }
    if (!sweep.shard.empty()) {
        text += format("  shard     {}\n", sweep.shard);
    }
    if (sweep.rows < sweep.all_rows) {
        text += format("  done      {} of {} rows\n", sweep.rows, sweep.all_rows);
    }
    if (sweep.laws > 0) {
        text += format("  laws      {}, which a sweep does not hold\n", sweep.laws);
    }
    for (const SweptOutput& output : sweep.outputs) {
        text += OutputText(output, sweep);
    }
    return text + format("\ndriver {}, fingerprint {}\n", sweep.driver, sweep.fingerprint);
}

}  // namespace etalon
