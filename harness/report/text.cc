#include "report/text.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/format.h"

namespace etalon {
namespace {

std::string InputText(const Observation& observation, bool hexadecimal) {
    std::string text;
    for (const auto& [name, value] : observation.inputs) {
        text += (text.empty() ? "" : ", ") + name + "=" + (hexadecimal ? value.hex : value.decimal);
    }
    return text;
}

std::string Join(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

}  // namespace

std::string ShortNumber(double value) {
    if (std::isinf(value)) {
        return value > 0 ? "infinite" : "-infinite";
    }
    if (value == 0) {
        return "0";
    }
    return format("{:.3g}", value);
}

std::string WorstText(const Observation& observation) {
    return format("{}: {} ulp, {} % of the tolerance, at {}", observation.output,
                  ShortNumber(observation.ulp_error), ShortNumber(100 * observation.used),
                  InputText(observation, false));
}

std::string FiguresText(const Record& record) {
    std::string text;
    for (const FigureSeen& figure : record.figures) {
        text +=
            format("{}figure {}, saw {}", text.empty() ? "" : "; ", figure.expected, figure.seen);
    }
    return text;
}

std::string ShareText(const ShareCount& count) {
    const auto part = [](std::uint64_t some, std::uint64_t all, double allowed) {
        const double share = all == 0 ? 0 : static_cast<double>(some) / static_cast<double>(all);
        return format("{} of {} ({} %, {} % allowed)", some, all, ShortNumber(100 * share),
                      ShortNumber(100 * allowed));
    };
    std::string text = count.output + ": ";
    if (count.search) {
        text += "missed " + part(count.missed, count.hits, count.missed_allowed) + ", ";
    }
    text += "wrong " + part(count.wrong, count.rows, count.wrong_allowed);
    if (count.search) {
        text += ", worst right hit off by " + ShortNumber(count.worst_right);
    }
    if (count.undecided > 0) {
        text += format(", undecided {}", count.undecided);
    }
    return text;
}

namespace {

std::string RowsText(const Record& record) {
    return format("{}{} rows, seed {}", record.rows,
                  record.rows < record.all_rows ? format(" of {}", record.all_rows) : "",
                  record.seed);
}

std::string PlaceText(const Observation& observation) {
    return format("\n  input     {}\n            {}\n  output    {}\n  actual    {} = {}",
                  InputText(observation, false), InputText(observation, true), observation.output,
                  observation.actual.decimal, observation.actual.hex);
}

std::string AllowedText(const AllowedValue& allowed) {
    if (!allowed.bounded) {
        return "anything";
    }
    std::string low = allowed.low.decimal + " = " + allowed.low.hex;
    if (allowed.low.hex == allowed.high.hex) {
        return low;
    }
    return low + " to " + allowed.high.decimal + " = " + allowed.high.hex +
           (allowed.quantum ? ", in multiples of " + allowed.quantum->hex : "");
}

std::string RefusedText(const Record& record, const Observation& worst) {
    std::string text = format("\n  refused   {} of {} values ({}); the worst:", record.refused,
                              record.judged, RowsText(record)) +
                       PlaceText(worst);
    if (worst.expected) {
        text += "\n  expected  " + worst.expected->decimal + " = " + worst.expected->hex;
    }
    if (worst.allowed && worst.rule.starts_with("spec ")) {
        text += format("\n  allowed   {}\n  error     {} ulp outside", AllowedText(*worst.allowed),
                       ShortNumber(worst.allowed->excess));
    } else {
        text +=
            format("\n  error     {} ulp, {} absolute, {} times the tolerance",
                   ShortNumber(worst.ulp_error), ShortNumber(worst.error), ShortNumber(worst.used));
    }
    return text + "\n  rule      " + worst.rule;
}

std::string OutsideText(const Record& record, const Observation& worst) {
    std::string text =
        format("\n  outside   {} of {} values ({}) are not what {} allows; the furthest:",
               record.outside, record.held, RowsText(record), record.profile) +
        PlaceText(worst);
    if (worst.expected) {
        text += "\n  expected  " + worst.expected->decimal + " = " + worst.expected->hex;
    }
    return text + format("\n  allowed   {}\n  error     {} ulp outside",
                         AllowedText(*worst.allowed), ShortNumber(worst.allowed->excess));
}

std::string BlameText(const Record& record, const Observation& shown) {
    if (!shown.budget) {
        return record.unevaluated.empty() ? "" : "\n  culprit   not known: " + record.unevaluated;
    }
    const Budget& budget = *shown.budget;
    std::string text = "\n  culprit   " + budget.culprit;
    if (record.culprits.size() > 1) {
        std::string counts;
        for (const auto& [culprit, values] : record.culprits) {
            counts += format("{}{} {}", counts.empty() ? "" : "; ", culprit, values);
        }
        text += " (of all that was refused: " + counts + ")";
    }
    text += "\n  parts     " + BudgetText(budget);
    if (record.outside > 0 && record.verdict != Verdict::kNonconforming) {
        text += format("\n  outside   {} of {} values are not what {} allows", record.outside,
                       record.held, record.profile);
    }
    return text;
}

}  // namespace

std::string BudgetText(const Budget& budget) {
    std::string text;
    const auto add = [&](const char* reading, const char* part, const PartSeen& seen) {
        const std::string error = ShortNumber(seen.ulp) + " ulp";
        const bool holds = seen.absolute == 0 && seen.ulp == 0;
        text += text.empty() ? "" : ", ";
        text += budget.is_law ? reading + (holds ? " holds" : " breaks it by " + error)
                              : part + (" " + error);
    };
    if (budget.method) {
        add("method", "method", *budget.method);
    }
    add("strict evaluation", "rounding", budget.rounding);
    add("device", "driver", budget.driver);
    return text;
}

std::string PartsText(const Record& record) {
    std::string text;
    for (const WorstPart& worst : record.parts) {
        text += format("{}{} {} ulp", text.empty() ? "parts at most " : ", ", worst.part,
                       ShortNumber(worst.seen.ulp));
    }
    return text;
}

std::string FailureText(const Record& record) {
    std::string text = format("{} on {} ({}): {}", record.case_path, record.device, record.recipe,
                              VerdictName(record.verdict));
    if (!record.reason.empty()) {
        text += "\n  reason    " + record.reason;
    }
    for (const ShareCount& count : record.shares) {
        text += "\n  shares    " + ShareText(count);
    }
    if (const Observation* shown = record.Shown()) {
        text += record.verdict == Verdict::kNonconforming ? OutsideText(record, *shown)
                                                          : RefusedText(record, *shown);
        text += BlameText(record, *shown);
    }
    if (!record.known_cause.empty()) {
        text += "\n  known     " + record.known_cause;
    }
    text += "\n  repeat    " + record.repeat;
    return text;
}

std::string SummaryText(const RunRecord& run) {
    struct Count {
        int pass = 0, fail = 0, nonconforming = 0, known = 0, skip = 0, crash = 0, timeout = 0;
        const Record* tightest = nullptr;
    };
    std::map<std::string, Count> by_device;
    std::map<std::string, int> reasons;
    std::map<std::string, int> causes;
    std::map<std::string, int> unevaluated;
    struct Held {
        std::uint64_t values = 0, unbounded = 0, outside = 0, void_bounds = 0;
    };
    std::map<std::string, Held> held_to;
    std::string flakes;
    for (const Record& record : run.records) {
        if (!record.unevaluated.empty()) {
            ++unevaluated[record.unevaluated];
        } else if (record.held > 0) {
            Held& held = held_to[record.profile];
            held.values += record.held;
            held.unbounded += record.unbounded;
            held.outside += record.outside;
            held.void_bounds += record.void_bounds;
        }
        Count& count = by_device[record.device];
        switch (record.verdict) {
            case Verdict::kPass:
                ++count.pass;
                if (record.worst && (count.tightest == nullptr ||
                                     record.worst->used > count.tightest->worst->used)) {
                    count.tightest = &record;
                }
                break;
            case Verdict::kSkip:
                ++count.skip;
                ++reasons[record.reason];
                break;
            case Verdict::kFail:
            case Verdict::kNonconforming:
            case Verdict::kCrash:
            case Verdict::kTimeout:
                if (!record.known_cause.empty()) {
                    ++count.known;
                    ++causes[record.known_cause];
                } else if (record.verdict == Verdict::kFail) {
                    ++count.fail;
                } else if (record.verdict == Verdict::kNonconforming) {
                    ++count.nonconforming;
                } else if (record.verdict == Verdict::kCrash) {
                    ++count.crash;
                } else {
                    ++count.timeout;
                }
                break;
        }
        if (!record.flake.empty()) {
            flakes += format("  {} on {} ({}): {}\n", record.case_path, record.device,
                             record.recipe, record.flake);
        }
    }
    std::string text =
        format("{:<28} {:>5} {:>5} {:>13} {:>5} {:>5} {:>5} {:>7}  {}\n", "device", "pass", "fail",
               "nonconforming", "known", "skip", "crash", "timeout", "least margin");
    for (const DeviceInfo& info : run.devices) {
        const std::string& device = info.name;
        const Count& count = by_device[device];
        std::string margin = "-";
        if (count.tightest != nullptr) {
            margin = format("{:.1f} %  {} ({})", 100 * (1 - count.tightest->worst->used),
                            count.tightest->case_path, count.tightest->recipe);
        }
        text += format("{:<28} {:>5} {:>5} {:>13} {:>5} {:>5} {:>5} {:>7}  {}\n", device,
                       count.pass, count.fail, count.nonconforming, count.known, count.skip,
                       count.crash, count.timeout, margin);
    }
    for (const auto& [profile, held] : held_to) {
        text += format("held to {}: {} values, {} unbounded, {} outside\n", profile, held.values,
                       held.unbounded, held.outside);
        if (held.void_bounds > 0) {
            text +=
                format("a fault of Etalon's own: {} bounds by {} leave out the strict evaluation\n",
                       held.void_bounds, profile);
        }
    }
    for (const auto& [reason, times] : unevaluated) {
        text += format("not evaluated, {} times: {}\n", times, reason);
    }
    for (const auto& [cause, times] : causes) {
        text += format("known failure, {} times: {}\n", times, cause);
    }
    for (const auto& [reason, times] : reasons) {
        text += format("skipped, {} times: {}\n", times, reason);
    }
    if (!flakes.empty()) {
        text += "failed once and not again:\n" + flakes;
    }
    return text;
}

std::string SlowestText(const RunRecord& run, std::size_t count) {
    struct Time {
        double prepared = 0;
        double all = 0;
    };
    std::map<std::string, Time> times;
    double all = 0;
    for (const CaseNote& note : run.cases) {
        times[note.path] = {note.seconds, note.seconds};
        all += note.seconds;
    }
    for (const Record& record : run.records) {
        times[record.case_path].all += record.seconds;
        all += record.seconds;
    }
    std::vector<std::pair<std::string, Time>> cases(times.begin(), times.end());
    std::stable_sort(cases.begin(), cases.end(),
                     [](const auto& a, const auto& b) { return a.second.all > b.second.all; });
    std::string text = format("{:>8} {:>8} {:>9}  slowest of {} cases, {:.1f} s in all\n",
                              "seconds", "share", "prepared", cases.size(), all);
    for (std::size_t i = 0; i < std::min(count, cases.size()); ++i) {
        const auto& [path, time] = cases[i];
        text += format("{:>8.3f} {:>6.1f} % {:>9.3f}  {}\n", time.all,
                       all > 0 ? 100 * time.all / all : 0, time.prepared, path);
    }
    return text;
}

std::string DevicesText(const RunRecord& run, bool with_absent) {
    std::string text;
    for (const DeviceInfo& device : run.devices) {
        text += format(
            "{}\n  implementation  {}\n  driver          {} {}\n  api             {}{}\n"
            "  compiler        {}\n  features        {}\n  float controls  {}\n"
            "  fingerprint     {}\n",
            device.name, device.description, device.driver, device.version, device.api,
            device.glsl_version == 0 ? "" : format(", GLSL {}", device.glsl_version),
            device.compiler.empty() ? "not told" : device.compiler, Join(device.features),
            device.float_controls.empty() ? "not told" : Join(device.float_controls),
            Fingerprint(device));
    }
    if (with_absent) {
        for (const DeviceNote& note : run.absent) {
            text += format("not here: {}: {}\n", note.name, note.reason);
        }
    }
    return text;
}

}  // namespace etalon
