#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/format.h"
#include "report/explanation.h"
#include "report/text.h"

namespace etalon {
namespace {

// Of a longer path only so many steps are printed at either end.
constexpr std::size_t kEnds = 20;
constexpr std::size_t kWorst = 10;  // and so many of those that lose most

using Row = std::vector<std::string>;

// Columns as wide as they must be, two spaces apart. A row of one cell is a heading.
std::string Aligned(const std::vector<Row>& rows) {
    std::vector<std::size_t> widths;
    for (const Row& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; row.size() > 1 && i < row.size(); ++i) {
            widths[i] = std::max(widths[i], row[i].size());
        }
    }
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            line += row[i];
            line += row.size() > 1 && row[i].size() < widths[i] + 2
                        ? std::string(widths[i] + 2 - row[i].size(), ' ')
                        : "";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string InputText(const Explanation& explanation, bool hexadecimal) {
    std::string text;
    for (const auto& [name, value] : explanation.inputs) {
        text += (text.empty() ? "" : ", ") + name + "=" + (hexadecimal ? value.hex : value.decimal);
    }
    return text;
}

std::string UlpText(double ulp) {
    return ShortNumber(ulp) + " ulp";
}

std::string Times(double factor) {
    if (std::isnan(factor)) {
        return "-";
    }
    return ShortNumber(factor) + (std::isfinite(factor) ? "x" : "");
}

std::string VerdictText(const Record& record) {
    std::string text(VerdictName(record.verdict));
    for (const auto& [culprit, count] : record.culprits) {
        text += ": " + culprit;
    }
    if (!record.reason.empty()) {
        text += ": " + record.reason.substr(0, record.reason.find('\n'));
    }
    return text + (record.known_cause.empty() ? "" : " (known: " + record.known_cause + ")");
}

// What the record's one value is made of; null where it was not judged.
const Observation* Seen(const Record& record) {
    return record.worst ? &*record.worst : record.worst_outside ? &*record.worst_outside : nullptr;
}

std::string DevicesTable(const Explanation& explanation) {
    std::vector<Row> rows = {
        {"device", "recipe", "result", "method", "rounding", "driver", "verdict"}};
    for (const ExplainedDevice& device : explanation.devices) {
        const Observation* seen = Seen(device.record);
        const std::string result = device.result.decimal.empty() ? "-" : device.result.decimal;
        Row row = {device.record.device, device.record.recipe, result};
        if (seen != nullptr && seen->budget) {
            const Budget& budget = *seen->budget;
            row.push_back(budget.method ? UlpText(budget.method->ulp) : "-");
            row.push_back(UlpText(budget.rounding.ulp));
            row.push_back(UlpText(budget.driver.ulp));
        } else {
            row.insert(row.end(), {"-", "-", "-"});
        }
        row.push_back(VerdictText(device.record));
        rows.push_back(std::move(row));
    }
    return Aligned(rows);
}

// One line for each interval that a specification allows.
void AddAllowed(const Explanation& explanation, std::vector<Row>& rows) {
    std::vector<std::pair<std::string, std::set<std::string>>> told;  // with the specifications
    for (const ExplainedDevice& device : explanation.devices) {
        const Observation* seen = Seen(device.record);
        if (seen == nullptr || !seen->allowed) {
            continue;
        }
        const AllowedValue& allowed = *seen->allowed;
        const std::string text = allowed.bounded
                                     ? allowed.low.decimal + " to " + allowed.high.decimal
                                     : "anything: there is no bound of use here";
        const auto same = std::find_if(told.begin(), told.end(),
                                       [&](const auto& one) { return one.first == text; });
        if (same == told.end()) {
            told.push_back({text, {device.record.profile}});
        } else {
            same->second.insert(device.record.profile);
        }
    }
    for (const auto& [text, profiles] : told) {
        std::string names;
        for (const std::string& profile : profiles) {
            names += (names.empty() ? "" : " and ") + profile;
        }
        rows.push_back({"allowed", text + ", by " + names});
    }
}

// Places in `steps` of those that are printed, ascending.
std::vector<std::size_t> Shown(const Explanation& explanation, bool all) {
    const std::vector<ExplainedStep>& steps = explanation.steps;
    std::vector<std::size_t> shown(steps.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        shown[i] = i;
    }
    if (all || steps.size() <= 2 * kEnds + kWorst) {
        return shown;
    }
    const auto loss = [&](std::size_t i) {
        double most = 0;
        for (const ExplainedValue& value : steps[i].values) {
            most = std::max(most, value.reaches_output ? value.lost_bits : 0);
        }
        return most;
    };
    std::set<std::size_t> chosen(shown.begin(), shown.begin() + kEnds);
    chosen.insert(shown.end() - kEnds, shown.end());
    for (const ExplainedDevice& device : explanation.devices) {
        if (device.parting.happens) {
            chosen.insert(device.parting.step - 1);
        }
    }
    std::stable_sort(shown.begin(), shown.end(),
                     [&](std::size_t a, std::size_t b) { return loss(a) > loss(b); });
    chosen.insert(shown.begin(), shown.begin() + kWorst);
    std::size_t otherwise = 0;
    for (std::size_t i = 0; i < steps.size() && otherwise < kWorst; ++i) {
        if (steps[i].decides_otherwise) {
            chosen.insert(i);
            ++otherwise;
        }
    }
    return {chosen.begin(), chosen.end()};
}

std::string Note(const Explanation& explanation, const ExplainedStep& step, std::size_t value) {
    std::string note;
    const auto add = [&](const std::string& more) { note += (note.empty() ? "" : "; ") + more; };
    if (explanation.worst_step == step.number && explanation.worst_value == value) {
        add(format("<- {} bits are lost here", std::lround(step.values[value].lost_bits)));
    }
    if (step.decides_otherwise && value == 0) {
        add("<- exact operands decide otherwise");
    }
    for (const ExplainedDevice& device : explanation.devices) {
        if (device.parting.happens && device.parting.step == step.number &&
            device.parting.part == step.values[value].part) {
            add("<- " + device.record.device + " parts here");
        }
    }
    return note;
}

std::string StepsTable(const Explanation& explanation, bool all) {
    if (explanation.steps.empty()) {
        return "no operation on floats: nothing is rounded on the way to the result\n";
    }
    std::vector<Row> rows = {{"#", "operation", "binary32", "exact", "error", "amplified", ""}};
    std::string place;
    std::size_t next = 0;
    for (const std::size_t at : Shown(explanation, all)) {
        const ExplainedStep& step = explanation.steps[at];
        if (at != next) {
            rows.push_back({format("   ... {} operations", at - next)});
        }
        next = at + 1;
        const std::string here =
            step.file.empty() ? "generated text" : format("{}:{}", step.file, step.line);
        if (here != place) {
            rows.push_back({here + (step.text.empty() ? "" : ": " + step.text)});
            place = here;
        }
        for (std::size_t i = 0; i < step.values.size(); ++i) {
            const ExplainedValue& value = step.values[i];
            const std::string name = step.name.empty() ? "" : step.name + value.part + " = ";
            const std::string operation =
                name + step.operation +
                (step.name.empty() && !value.part.empty() ? "  " + value.part : "");
            if (step.is_decision) {
                rows.push_back({format("#{}", step.number), operation, value.strict.decimal,
                                value.exact.decimal, "", "", Note(explanation, step, i)});
                continue;
            }
            rows.push_back({i == 0 ? format("#{}", step.number) : "", operation,
                            value.strict.decimal, value.exact.decimal, UlpText(value.error_ulp),
                            Times(value.amplification), Note(explanation, step, i)});
        }
    }
    if (explanation.is_cut) {
        rows.push_back({"   ... and more: the path is longer than what is traced"});
    }
    return Aligned(rows);
}

}  // namespace

std::string ExplanationText(const Explanation& explanation, bool all) {
    std::vector<Row> head = {{"case", explanation.case_path},
                             {"input", InputText(explanation, false)}};
    if (InputText(explanation, true) != InputText(explanation, false)) {
        head.push_back({"", InputText(explanation, true)});
    }
    if (!explanation.chosen.empty()) {
        head.push_back({"", explanation.chosen});
    }
    head.push_back({"output", explanation.output +
                                  (explanation.rule.empty() ? "" : ", by " + explanation.rule)});
    if (explanation.truth) {
        head.push_back({"truth", explanation.truth->decimal});
    }
    head.push_back({"exact", explanation.method.decimal + ", the program without rounding"});
    head.push_back(
        {"binary32", explanation.strict.decimal + ", each operation rounded, in source order"});
    AddAllowed(explanation, head);
    const std::string text =
        Aligned(head) + "\n" + DevicesTable(explanation) + "\n" + StepsTable(explanation, all);
    std::vector<Row> partings;
    for (const ExplainedDevice& device : explanation.devices) {
        if (!device.parting.text.empty()) {
            partings.push_back({device.record.device, device.record.recipe, device.parting.text});
        }
    }
    return text + (partings.empty() ? "" : "\n" + Aligned(partings));
}

}  // namespace etalon
