#include "report/catalogue.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "base/format.h"
#include "report/text.h"

namespace etalon {
namespace {

constexpr const char* kPublished = "shaders/published/";

using Notes = std::vector<const CaseNote*>;

bool IsDefect(const CatalogueEntry& entry) {
    return entry.id.starts_with('D');
}

bool IsPublished(const CaseNote& note) {
    return std::any_of(note.functions.begin(), note.functions.end(),
                       [](const FunctionNote& one) { return one.file.starts_with(kPublished); });
}

Notes Covering(const std::string& id, const RunRecord& run) {
    Notes notes;
    for (const CaseNote& note : run.cases) {
        if (std::find(note.covers.begin(), note.covers.end(), id) != note.covers.end()) {
            notes.push_back(&note);
        }
    }
    return notes;
}

// A table's cell: bars and line ends would end it.
std::string Cell(const std::string& text) {
    std::string cell;
    for (const char c : text) {
        cell += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
    }
    return cell.empty() ? "-" : cell;
}

std::string Joined(const std::vector<std::string>& texts, const std::string& between) {
    std::string joined;
    for (const std::string& text : texts) {
        joined += (joined.empty() ? "" : between) + text;
    }
    return joined;
}

// "`folder`: a, b" for each folder, from pairs of folder and name.
std::string Grouped(const std::set<std::pair<std::string, std::string>>& pairs) {
    std::map<std::string, std::vector<std::string>> groups;
    for (const auto& [folder, name] : pairs) {
        groups[folder].push_back(name);
    }
    std::vector<std::string> texts;
    for (const auto& [folder, names] : groups) {
        texts.push_back("`" + folder + "`: " + Joined(names, ", "));
    }
    return Joined(texts, "<br>");
}

std::string FunctionsCell(const Notes& notes) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (const CaseNote* note : notes) {
        for (const FunctionNote& function : note->functions) {
            pairs.emplace(function.file, function.name);
        }
    }
    return Grouped(pairs);
}

std::string CasesCell(const Notes& notes) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (const CaseNote* note : notes) {
        const std::size_t slash = note->path.rfind('/');
        const std::string folder = slash == std::string::npos ? "." : note->path.substr(0, slash);
        pairs.emplace(folder, note->path.substr(slash + 1));
    }
    return format("{}: {}", notes.size(), Grouped(pairs));
}

// The oracle functions that the expressions name, "expression" for one that names none, and laws.
std::string OraclesCell(const Notes& notes) {
    std::set<std::string> words;
    for (const CaseNote* note : notes) {
        for (const std::string& oracle : note->oracles) {
            const std::size_t before = words.size();
            bool named = false;
            for (std::size_t at = 0; at < oracle.size();) {
                std::size_t end = at;
                const auto is_part = [&](char c) {
                    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
                };
                while (end < oracle.size() && is_part(oracle[end])) {
                    ++end;
                }
                const std::string word = oracle.substr(at, end - at);
                const bool begins = std::isalpha(static_cast<unsigned char>(oracle[at])) != 0;
                if (begins && word.find('.') != std::string::npos && oracle[end] == '(') {
                    words.insert("`" + word + "`");
                    named = true;
                }
                at = std::max(end, at + 1);
            }
            if (!named && words.size() == before) {
                words.insert("expression");
            }
        }
        if (note->laws > 0) {
            words.insert("laws");
        }
    }
    return Joined({words.begin(), words.end()}, ", ");
}

// The number that follows a word of a rule.
std::optional<double> Granted(const std::string& rule, const std::string& word) {
    std::istringstream words(rule);
    std::string one;
    while (words >> one) {
        if (one == word && words >> one) {
            return std::strtod(one.c_str(), nullptr);
        }
    }
    return std::nullopt;
}

// The worst errors on one device, each in the measure by which it was accepted.
struct Worst {
    std::optional<double> ulp;
    std::optional<double> absolute;
    std::optional<double> relative;
    std::optional<double> missed;  // share
    std::optional<double> wrong;   // share
    bool exact = false;
    bool laws = false;
    bool conforms = false;
    bool fails = false;
    bool known = false;

    static void Raise(std::optional<double>& worst, double value) {
        worst = std::max(worst.value_or(0), value);
    }

    void Add(const Record& record) {
        if (record.verdict != Verdict::kPass) {
            known = known || (record.verdict != Verdict::kSkip && record.Good());
            fails = fails || !record.Good();
            return;
        }
        for (const ShareCount& share : record.shares) {
            const auto of = [](std::uint64_t part, std::uint64_t all) {
                return all == 0 ? 0 : static_cast<double>(part) / static_cast<double>(all);
            };
            Raise(wrong, of(share.wrong, share.rows));
            if (share.search) {
                Raise(missed, of(share.missed, share.hits));
                Raise(absolute, share.worst_right);
            }
        }
        if (record.worst && record.shares.empty()) {
            Add(*record.worst);
        }
    }

    // Two digits: more differ from machine to machine.
    std::string Text() const {
        std::vector<std::string> parts;
        const auto add = [&parts](const std::optional<double>& value, double scale,
                                  const char* unit) {
            if (value && *value > 0) {
                parts.push_back(format("{:.2g}{}", *value * scale, unit));
            }
        };
        add(ulp, 1, " ulp");
        add(absolute, 1, " absolute");
        add(relative, 1, " relative");
        add(missed, 100, " % missed");
        add(wrong, 100, " % wrong");
        if (parts.empty() && (exact || ulp || absolute || relative || wrong)) {
            parts.emplace_back("exact");
        }
        if (parts.empty() && laws) {
            parts.emplace_back("laws hold");
        }
        if (parts.empty() && conforms) {
            parts.emplace_back("within the specification");
        }
        if (known) {
            parts.emplace_back("known failure");
        }
        if (fails) {
            parts.emplace_back("**fails**");
        }
        return Joined(parts, ", ");
    }

  private:
    void Add(const Observation& worst) {
        if (worst.output.starts_with("law '")) {
            laws = true;
            return;
        }
        if (worst.rule.starts_with("spec ")) {
            conforms = true;
            return;
        }
        const auto by_ulp = Granted(worst.rule, "ulp");
        const auto by_absolute = Granted(worst.rule, "absolute");
        const auto by_relative = Granted(worst.rule, "relative");
        if (by_ulp && (worst.ulp_error <= *by_ulp || (!by_absolute && !by_relative))) {
            Raise(ulp, worst.ulp_error);
        } else if (by_absolute && (worst.error <= *by_absolute || !by_relative)) {
            Raise(absolute, worst.error);
        } else if (by_relative) {
            const double expected = std::strtod(worst.expected->decimal.c_str(), nullptr);
            Raise(relative, worst.error == 0 ? 0 : worst.error / std::fabs(expected));
        } else {
            exact = true;
        }
    }
};

std::vector<const Record*> RecordsOf(const Notes& notes, const RunRecord& run) {
    std::set<std::string> paths;
    for (const CaseNote* note : notes) {
        paths.insert(note->path);
    }
    std::vector<const Record*> records;
    for (const Record& record : run.records) {
        if (paths.contains(record.case_path)) {
            records.push_back(&record);
        }
    }
    return records;
}

// What is said of each device; devices of which the same is said stand together.
std::string ByDevice(const RunRecord& run,
                     const std::function<std::string(const std::string&)>& of) {
    std::vector<std::pair<std::string, std::vector<std::string>>> groups;
    for (const DeviceInfo& device : run.devices) {
        const std::string text = of(device.name);
        if (text.empty()) {
            continue;
        }
        auto same = std::find_if(groups.begin(), groups.end(),
                                 [&](const auto& group) { return group.first == text; });
        if (same == groups.end()) {
            groups.push_back({text, {}});
            same = groups.end() - 1;
        }
        same->second.push_back(device.name);
    }
    std::vector<std::string> texts;
    for (const auto& [text, devices] : groups) {
        const bool all = groups.size() == 1 && devices.size() == run.devices.size();
        texts.push_back(text + (all ? "" : " (" + Joined(devices, ", ") + ")"));
    }
    return Joined(texts, "<br>");
}

// The worst errors of the hardened forms.
std::string WorstCell(const Notes& notes, const RunRecord& run) {
    Notes hardened = notes;
    std::erase_if(hardened, [](const CaseNote* note) { return IsPublished(*note); });
    const std::vector<const Record*> records = RecordsOf(hardened, run);
    return ByDevice(run, [&](const std::string& device) {
        Worst worst;
        for (const Record* record : records) {
            if (record->device == device) {
                worst.Add(*record);
            }
        }
        return worst.Text();
    });
}

// A number to four digits, other text as it is.
std::string Rounded(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    return *end == 0 && !text.empty() ? format("{:.4g}", number) : text;
}

// Of the published forms, by case: the figure that was expected and what was seen.
std::string FiguresCell(const Notes& notes, const RunRecord& run) {
    std::vector<std::string> texts;
    for (const CaseNote* note : notes) {
        if (!IsPublished(*note)) {
            continue;
        }
        const std::vector<const Record*> records = RecordsOf({note}, run);
        std::vector<std::string> figures;
        for (const Record* record : records) {
            for (const FigureSeen& figure : record->figures) {
                if (std::find(figures.begin(), figures.end(), figure.expected) == figures.end()) {
                    figures.push_back(figure.expected);
                }
            }
        }
        const std::string name = "`" + note->path + "`: ";
        for (const std::string& expected : figures) {
            const std::string seen = ByDevice(run, [&](const std::string& device) {
                std::set<std::string> values;
                for (const Record* record : records) {
                    for (const FigureSeen& figure : record->figures) {
                        if (record->device == device && figure.expected == expected) {
                            values.insert(Rounded(figure.seen));
                        }
                    }
                }
                return Joined({values.begin(), values.end()}, " or ");
            });
            texts.push_back(name + expected + "; saw " + seen);
        }
        const bool fails = std::any_of(records.begin(), records.end(), [](const Record* record) {
            return !record->known_cause.empty();
        });
        if (figures.empty() && fails) {
            texts.push_back(name + "fails as expected");
        }
    }
    return Joined(texts, "<br>");
}

std::string Row(const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells) {
        row += " " + Cell(cell) + " |";
    }
    return row + "\n";
}

std::string EntryRow(const CatalogueEntry& entry, const Notes& notes, const RunRecord& run) {
    std::vector<std::string> cells = {entry.id, entry.name, entry.source};
    if (notes.empty()) {
        cells.insert(cells.end(), {"", entry.reason.empty() ? "**missing**" : "by reading", ""});
    } else {
        cells.insert(cells.end(), {FunctionsCell(notes), CasesCell(notes), OraclesCell(notes)});
    }
    if (IsDefect(entry)) {
        const std::string figures = FiguresCell(notes, run);
        cells.push_back(figures.empty() ? entry.reason : figures);
    }
    cells.push_back(WorstCell(notes, run));
    return Row(cells);
}

std::string Table(const std::vector<CatalogueEntry>& entries, const RunRecord& run,
                  bool chosen_only, bool defects) {
    std::string rows;
    for (const CatalogueEntry& entry : entries) {
        const Notes notes = Covering(entry.id, run);
        if (IsDefect(entry) == defects && !(chosen_only && notes.empty())) {
            rows += EntryRow(entry, notes, run);
        }
    }
    std::vector<std::string> head = {
        "id", defects ? "defect" : "function", "source", "GLSL functions", "cases", "oracle"};
    if (defects) {
        head.emplace_back("published: expected and seen");
    }
    head.emplace_back("hardened: worst error");
    return Row(head) + Row(std::vector<std::string>(head.size(), "---")) + rows;
}

}  // namespace

std::vector<std::string> MissingIds(const std::vector<CatalogueEntry>& entries,
                                    const RunRecord& run) {
    std::vector<std::string> missing;
    for (const CatalogueEntry& entry : entries) {
        if (entry.reason.empty() && Covering(entry.id, run).empty()) {
            missing.push_back(entry.id);
        }
    }
    return missing;
}

std::string CatalogueMarkdown(const std::vector<CatalogueEntry>& entries, const RunRecord& run,
                              bool chosen_only) {
    std::string devices;
    for (const DeviceInfo& device : run.devices) {
        devices += format("- {}: {}, {} {}\n", device.name, device.description, device.driver,
                          device.version);
    }
    return "# The catalogue\n\nWritten by `etalon run --catalogue`, of these devices:\n\n" +
           devices +
           "\nAn error is the worst of all cases and recipes that pass, in the measure by which it "
           "was accepted; it is the same on all devices where none is named.\n\n## Functions\n\n" +
           Table(entries, run, chosen_only, false) + "\n## Defects\n\n" +
           Table(entries, run, chosen_only, true);
}

}  // namespace etalon
