#include "case/read_judgement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/file.h"

namespace etalon {
namespace {

constexpr std::array<std::string_view, 8> kRuleKeys = {"exact", "ulp",    "absolute", "relative",
                                                       "flush", "missed", "wrong",    "beyond"};

std::string Trim(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) {
        return "";
    }
    return text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
}

// The keys of `accept` that let a share of the values be off; `rule` has its tolerances.
Result<std::optional<Shares>> ReadShares(const TomlReader& reader, const toml::table& table,
                                         const Acceptance& rule, bool exact) {
    Shares shares;
    bool given = false;
    const std::pair<const char*, double*> parts[] = {{"missed", &shares.missed},
                                                     {"wrong", &shares.wrong}};
    for (const auto& [key, share] : parts) {
        const toml::node* node = table.get(key);
        if (node == nullptr) {
            continue;
        }
        const std::string what = "'" + std::string(key) + "'";
        ETALON_TRY(number, reader.Number(*node, what));
        if (!(number >= 0)) {
            return reader.Fail(*node, what + " must be a share, from 0 to less than 0.5");
        }
        if (number >= 0.5) {
            return reader.Fail(*node, what +
                                          " must be less than 0.5: a rule that half of the "
                                          "values may break is none");
        }
        *share = number;
        given = true;
    }
    if (const toml::node* node = table.get("beyond")) {
        ETALON_TRY(beyond, reader.Number(*node, "'beyond'"));
        if (!(beyond > 0) || std::isinf(beyond)) {
            return reader.Fail(*node, "'beyond' must be a positive number");
        }
        if (rule.absolute && *rule.absolute >= beyond) {
            return reader.Fail(*node,
                               "'beyond' must be greater than 'absolute': no right hit could "
                               "be refused");
        }
        shares.beyond = beyond;
        given = true;
    }
    if (!given) {
        return std::optional<Shares>();
    }
    if (exact && (shares.beyond || table.contains("missed"))) {
        return reader.Fail(table,
                           "'missed' and 'beyond' need a tolerance (ulp, absolute or "
                           "relative)");
    }
    if (!exact && !shares.beyond) {
        return reader.Fail(table,
                           "'missed' and 'wrong' need 'beyond': how far from the truth a "
                           "hit is another one");
    }
    return std::optional(shares);
}

}  // namespace

Result<Acceptance> ReadAcceptance(const TomlReader& reader, const toml::table& table) {
    ETALON_TRY_STEP(reader.OnlyKeys(table, kRuleKeys));
    Acceptance rule;
    const std::pair<const char*, std::optional<double>*> tolerances[] = {
        {"ulp", &rule.ulp}, {"absolute", &rule.absolute}, {"relative", &rule.relative}};
    bool tolerant = false;
    for (const auto& [key, tolerance] : tolerances) {
        const toml::node* node = table.get(key);
        if (node == nullptr) {
            continue;
        }
        const std::string what = "'" + std::string(key) + "'";
        if (!node->is_number()) {
            return reader.Fail(*node, what + " must be a number");
        }
        ETALON_TRY(number, reader.Number(*node, what));
        if (!(number > 0) || std::isinf(number)) {
            return reader.Fail(*node,
                               what + " must be a positive number (exact = true grants none)");
        }
        *tolerance = number;
        tolerant = true;
    }
    if (rule.ulp && *rule.ulp >= 0x1p23) {
        return reader.Fail(*table.get("ulp"), "nothing could fail: 2^23 ulp reach to zero");
    }
    if (rule.relative && *rule.relative >= 1) {
        return reader.Fail(*table.get("relative"),
                           "nothing could fail: relative 1 reaches to zero");
    }
    if (const toml::node* node = table.get("flush")) {
        ETALON_TRY(flush, reader.Flag(*node, "'flush'"));
        rule.flush = flush;
    }
    bool exact = false;
    if (const toml::node* node = table.get("exact")) {
        ETALON_TRY(flag, reader.Flag(*node, "'exact'"));
        exact = flag;
    }
    if (exact == tolerant) {
        return reader.Fail(table, exact ? "'exact' and a tolerance contradict each other"
                                        : "the acceptance grants nothing: give ulp, absolute, "
                                          "relative, or exact = true");
    }
    ETALON_TRY(shares, ReadShares(reader, table, rule, exact));
    rule.shares = shares;
    return rule;
}

Result<std::string> ReadSpec(const TomlReader& reader, const toml::table& table) {
    std::vector<std::string_view> known(kRuleKeys.begin(), kRuleKeys.end());
    known.push_back("spec");
    ETALON_TRY_STEP(reader.OnlyKeys(table, known));
    for (const auto& [key, node] : TomlReader::InOrder(table)) {
        if (key != "spec") {
            return reader.Fail(*node, "'spec' and '" + key +
                                          "' contradict each other: what the specification "
                                          "allows is accepted, no more and no less");
        }
    }
    return reader.TextAt(table, "spec", std::nullopt);
}

Result<Comparison> SplitComparison(const std::string& holds) {
    constexpr std::pair<std::string_view, Relation> kRelations[] = {{"==", Relation::kEqual},
                                                                    {"<=", Relation::kLessEqual},
                                                                    {">=", Relation::kGreaterEqual},
                                                                    {"<", Relation::kLess},
                                                                    {">", Relation::kGreater}};
    constexpr std::string_view kOthers[] = {"!=", "&&", "||", "?", ";"};
    std::optional<Comparison> found;
    int depth = 0;
    for (std::size_t at = 0; at < holds.size(); ++at) {
        const std::string_view rest = std::string_view(holds).substr(at);
        depth += holds[at] == '(' || holds[at] == '[' ? 1 : 0;
        depth -= holds[at] == ')' || holds[at] == ']' ? 1 : 0;
        if (depth < 0) {
            return Error{"a bracket is closed that was not opened"};
        }
        if (depth > 0) {
            continue;
        }
        if (rest.starts_with("<<") || rest.starts_with(">>")) {
            ++at;
            continue;
        }
        for (const std::string_view other : kOthers) {
            if (rest.starts_with(other)) {
                return Error{"'" + std::string(other) +
                             "' must stand in brackets; a law is one comparison"};
            }
        }
        for (const auto& [sign, relation] : kRelations) {
            if (!rest.starts_with(sign)) {
                continue;
            }
            if (found) {
                return Error{"more than one comparison stands outside brackets"};
            }
            found = Comparison{Trim(holds.substr(0, at)), relation,
                               Trim(holds.substr(at + sign.size()))};
            at += sign.size() - 1;
            break;
        }
    }
    if (depth != 0) {
        return Error{"a bracket is not closed"};
    }
    if (!found) {
        return Error{"a comparison (==, <=, >=, < or >) is missing"};
    }
    if (found->left.empty() || found->right.empty()) {
        return Error{"a side of the comparison is missing"};
    }
    return *found;
}

Result<Law> ReadLaw(const TomlReader& reader, const toml::table& table) {
    ETALON_TRY_STEP(reader.OnlyKeys(table, {"name", "holds", "within"}));
    Law law;
    ETALON_TRY(name, reader.TextAt(table, "name", std::nullopt));
    ETALON_TRY(holds, reader.TextAt(table, "holds", std::nullopt));
    law.name = name;
    law.place = reader.PlaceOf(*table.get("holds"));
    const auto comparison = SplitComparison(holds);
    if (!comparison) {
        return reader.Fail(*table.get("holds"), "'holds': " + comparison.error().message);
    }
    law.left = comparison->left;
    law.relation = comparison->relation;
    law.right = comparison->right;
    if (const toml::node* node = table.get("within")) {
        ETALON_TRY(within, reader.Table(*node, "'within'"));
        ETALON_TRY(rule, ReadAcceptance(reader, *within));
        if (rule.shares) {
            return reader.Fail(*node, "'within' grants no shares: a law holds at every row");
        }
        law.within = rule;
    }
    return law;
}

namespace {

Result<Figure> ReadFigure(const TomlReader& reader, const toml::table& table) {
    ETALON_TRY_STEP(
        reader.OnlyKeys(table, {"absolute", "relative", "ulp", "value", "refused", "within"}));
    Figure figure;
    int measures = 0;
    for (std::size_t i = 0; i < std::size(kMeasureNames); ++i) {
        const std::string name = kMeasureNames[i];
        const toml::node* node = table.get(name);
        if (node == nullptr) {
            continue;
        }
        ETALON_TRY(value, reader.Number(*node, "'" + name + "'"));
        figure.measure = static_cast<Figure::Measure>(i);
        figure.value = value;
        ++measures;
        if (figure.measure != Figure::Measure::kValue && !(value > 0)) {
            return reader.Fail(*node, "'" + name + "' must be a positive number");
        }
        if (figure.measure == Figure::Measure::kRefused && value > 1) {
            return reader.Fail(*node, "'refused' is a share, at most 1");
        }
    }
    if (measures != 1) {
        return reader.Fail(table,
                           "'figure' needs exactly one of absolute, relative, ulp, value and "
                           "refused");
    }
    if (const toml::node* node = table.get("within")) {
        ETALON_TRY(within, reader.Number(*node, "'within'"));
        if (!(within >= 0 && within < 1)) {
            return reader.Fail(*node, "'within' must be a number from 0 to below 1");
        }
        figure.within = within;
    }
    return figure;
}

}  // namespace

Result<ExpectedFailure> ReadExpectedFailure(const TomlReader& reader, const toml::table& table,
                                            const std::vector<Law>& laws) {
    ETALON_TRY_STEP(reader.OnlyKeys(
        table, {"device", "recipe", "law", "verdict", "status", "cause", "link", "figure"}));
    ETALON_TRY(device, reader.TextAt(table, "device", "*"));
    ETALON_TRY(recipe, reader.TextAt(table, "recipe", "*"));
    ETALON_TRY(law, reader.TextAt(table, "law", ""));
    ETALON_TRY(verdict, reader.TextAt(table, "verdict", "fail"));
    ETALON_TRY(status, reader.TextAt(table, "status", std::nullopt));
    ETALON_TRY(cause, reader.TextAt(table, "cause", std::nullopt));
    ETALON_TRY(link, reader.TextAt(table, "link", ""));
    constexpr std::string_view kStatuses[] = {"bug", "method", "rounding", "unimplemented",
                                              "undefined"};
    if (std::find(std::begin(kStatuses), std::end(kStatuses), status) == std::end(kStatuses)) {
        return reader.Fail(*table.get("status"),
                           "'status' must be bug, method, rounding, unimplemented or undefined");
    }
    constexpr std::string_view kVerdicts[] = {"fail", "nonconforming", "crash", "timeout"};
    if (std::find(std::begin(kVerdicts), std::end(kVerdicts), verdict) == std::end(kVerdicts)) {
        return reader.Fail(*table.get("verdict"),
                           "'verdict' must be fail, nonconforming, crash or timeout");
    }
    if (verdict == "nonconforming" && status != "bug") {
        return reader.Fail(*table.get("status"),
                           "'status' must be bug: what the specification does not allow is one");
    }
    const bool known = std::any_of(laws.begin(), laws.end(),
                                   [&law](const Law& one) { return GlobMatches(law, one.name); });
    if (!law.empty() && !known) {
        return reader.Fail(*table.get("law"), "no law is called '" + law + "'");
    }
    ExpectedFailure expected{device, recipe, law, verdict, status, cause, link, std::nullopt};
    if (const toml::node* node = table.get("figure")) {
        ETALON_TRY(measures, reader.Table(*node, "'figure'"));
        ETALON_TRY(figure, ReadFigure(reader, *measures));
        if (verdict != "fail") {
            return reader.Fail(*node, "'figure' is of a failure by numbers, not of a " + verdict);
        }
        expected.figure = figure;
    }
    return expected;
}

}  // namespace etalon
