#include "case/case.h"

#include <algorithm>
#include <cmath>

#include "case/like.h"
#include "case/read_case.h"
#include "case/read_domain.h"
#include "case/read_images.h"
#include "case/read_judgement.h"
#include "case/read_map.h"
#include "case/toml_reader.h"

// The keys of a case:
//
//   like              the file or address of a case or part whose keys this one has too
//   covers            ids of what the case shows
//   description, source, call, family, seed, with, include, define, out, recipes
//   oracle            an expression, or one by output: { result = "...", t = "..." }
//   accept            { exact = true } or any of ulp, absolute, relative, and flush = false; or
//                     { spec = "..." }, which needs no oracle; or by output
//   [images]          by sampler's name: file or expr, size, filter, wrap, levels, cube
//   combine, where    for all domains
//   [domain]          inputs by name, combine, where; or several [[domain]]
//   [[law]]           name, holds, within
//   [[expected_failure]]  device, recipe, law, verdict, status, cause, link, figure
//   [map]             over, ranges, at, size, output, spent, fails, safe, because

namespace etalon {
namespace {

std::filesystem::path FileOf(const std::filesystem::path& root, const std::string& path) {
    return root / "cases" / (path + ".toml");
}

// "F4": a capital and a number.
bool IsId(const std::string& text) {
    return text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' &&
           std::all_of(text.begin() + 1, text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

class CaseReader {
  public:
    CaseReader(const TomlReader& reader, const toml::table& table, Purpose purpose)
        : reader_(reader), table_(table), purpose_(purpose) {}

    Result<Case> Read() {
        ETALON_TRY_STEP(ReadCall());
        ETALON_TRY_STEP(ReadDomains());
        ETALON_TRY_STEP(ReadExpectations());
        if (purpose_ == Purpose::kMeasure) {
            return std::move(case_);
        }
        ETALON_TRY_STEP(ReadCovers());
        ETALON_TRY_STEP(ReadLaws());
        if (case_.expectations.empty() && case_.laws.empty()) {
            return reader_.Fail(
                1, "nothing is judged: give an oracle, a law, or accept = { spec = ... }");
        }
        ETALON_TRY(failures, Tables("expected_failure"));
        for (const toml::table* failure : failures) {
            ETALON_TRY(expected, ReadExpectedFailure(reader_, *failure, case_.laws));
            case_.expected_failures.push_back(expected);
        }
        if (const toml::node* node = table_.get("map")) {
            ETALON_TRY(table, reader_.Table(*node, "'map'"));
            ETALON_TRY(map, ReadMap(reader_, *table, case_.domains));
            case_.map = std::move(map);
        }
        return std::move(case_);
    }

  private:
    Status<> ReadCall() {
        ETALON_TRY(description, reader_.TextAt(table_, "description", ""));
        ETALON_TRY(source, reader_.TextAt(table_, "source", std::nullopt));
        ETALON_TRY(call, reader_.TextAt(table_, "call", std::nullopt));
        ETALON_TRY(family, reader_.TextAt(table_, "family", ""));
        case_.description = description;
        case_.source = source;
        case_.call = call;
        case_.source_place = reader_.PlaceOf(*table_.get("source"));
        case_.call_place = reader_.PlaceOf(*table_.get("call"));
        case_.family = family;
        const std::pair<const char*, std::vector<std::string>*> lists[] = {
            {"recipes", &case_.recipes}, {"with", &case_.with}, {"include", &case_.include}};
        for (const auto& [key, list] : lists) {
            if (const toml::node* node = table_.get(key)) {
                ETALON_TRY(texts, reader_.Texts(*node, "'" + std::string(key) + "'"));
                *list = texts;
            }
        }
        if (const toml::node* node = table_.get("with")) {
            case_.with_place = reader_.PlaceOf(*node);
        }
        const std::pair<const char*, std::map<std::string, std::string>*> maps[] = {
            {"define", &case_.define}, {"out", &case_.out}};
        for (const auto& [key, map] : maps) {
            if (const toml::node* node = table_.get(key)) {
                ETALON_TRY(texts, reader_.TextMap(*node, "'" + std::string(key) + "'"));
                *map = texts;
            }
        }
        for (const auto& [name, type] : case_.out) {
            if (auto columns = ColumnsOf(name, type); !columns) {
                return reader_.Fail(*table_.get("out"), "'out': " + columns.error().message);
            }
        }
        if (const toml::node* node = table_.get("images")) {
            ETALON_TRY(images, reader_.Table(*node, "'images'"));
            ETALON_TRY(read, ReadImages(reader_, *images));
            case_.images = std::move(read);
        }
        if (const toml::node* node = table_.get("seed")) {
            ETALON_TRY(seed, reader_.Count(*node, "'seed'"));
            case_.seed = seed;
        }
        return Ok();
    }

    Status<> ReadCovers() {
        const toml::node* node = table_.get("covers");
        if (node == nullptr) {
            return Ok();
        }
        ETALON_TRY(ids, reader_.Texts(*node, "'covers'"));
        for (const std::string& id : ids) {
            if (!IsId(id)) {
                return reader_.Fail(*node, "'covers': '" + id +
                                               "' is no id, which reads as F4 does: a letter "
                                               "and a number");
            }
            if (std::count(ids.begin(), ids.end(), id) > 1) {
                return reader_.Fail(*node, "'covers' names " + id + " twice");
            }
        }
        case_.covers = ids;
        case_.covers_place = reader_.PlaceOf(*node);
        return Ok();
    }

    // The tables under a key that may hold one or a list of them.
    Result<std::vector<const toml::table*>> Tables(const char* key) const {
        std::vector<const toml::table*> tables;
        const toml::node* node = table_.get(key);
        if (node == nullptr) {
            return tables;
        }
        if (const toml::table* one = node->as_table()) {
            tables.push_back(one);
            return tables;
        }
        const std::string what = "'" + std::string(key) + "'";
        ETALON_TRY(list, reader_.List(*node, what));
        for (const toml::node& entry : *list) {
            ETALON_TRY(table, reader_.Table(entry, what));
            tables.push_back(table);
        }
        return tables;
    }

    Status<> ReadDomains() {
        DomainDefaults defaults;
        if (const toml::node* node = table_.get("combine")) {
            ETALON_TRY(zip, ReadCombine(reader_, *node));
            defaults.zip = zip;
        }
        defaults.where = table_.get("where");
        ETALON_TRY(tables, Tables("domain"));
        if (tables.empty()) {
            return reader_.Fail(1, "[domain] is missing");
        }
        for (const toml::table* table : tables) {
            ETALON_TRY(domain, ReadDomain(reader_, *table, defaults));
            case_.domains.push_back(domain);
        }
        return Ok();
    }

    Status<> ReadExpectations() {
        const toml::node* oracle = table_.get("oracle");
        const toml::node* accept = table_.get("accept");
        const toml::table exact = toml::table{{"exact", true}};
        if (accept == nullptr && purpose_ == Purpose::kMeasure) {
            accept = oracle != nullptr ? &exact : nullptr;
            if (accept == nullptr) {
                return Ok();
            }
        }
        if (accept == nullptr) {
            return oracle == nullptr
                       ? Status<>(Ok())
                       : reader_.Fail(*oracle, "'accept' is missing: an oracle needs it");
        }
        ETALON_TRY(rules, reader_.Table(*accept, "'accept'"));
        if (oracle != nullptr && oracle->is_table()) {
            const toml::table& outputs = *oracle->as_table();
            if (outputs.empty()) {
                return reader_.Fail(*oracle, "'oracle' is empty");
            }
            for (const auto& [output, node] : TomlReader::InOrder(outputs)) {
                ETALON_TRY_STEP(ReadExpectation(output, node, *rules));
            }
        } else if (oracle != nullptr) {
            ETALON_TRY_STEP(ReadExpectation("result", oracle, *rules));
        } else if (rules->contains("spec")) {
            ETALON_TRY_STEP(ReadExpectation("result", nullptr, *rules));
        }
        for (const auto& [output, node] : TomlReader::InOrder(*rules)) {
            const bool judged = std::any_of(
                case_.expectations.begin(), case_.expectations.end(),
                [&output = output](const Expectation& one) { return one.output == output; });
            const toml::table* rule = node->as_table();
            if (rule == nullptr || judged) {
                continue;
            }
            if (!rule->contains("spec")) {
                return reader_.Fail(*node,
                                    "'accept' for '" + output + "' needs an 'oracle' for it");
            }
            ETALON_TRY_STEP(ReadExpectation(output, nullptr, *rules));
        }
        return case_.expectations.empty() ? reader_.Fail(*accept, "'accept' needs an 'oracle'")
                                          : Status<>(Ok());
    }

    // `oracle` is null where the rule does without.
    Status<> ReadExpectation(const std::string& output, const toml::node* oracle,
                             const toml::table& rules) {
        if (output != "result" && !case_.out.contains(output)) {
            return reader_.Fail(oracle != nullptr ? *oracle : rules,
                                std::string(oracle != nullptr ? "'oracle'" : "'accept'") +
                                    ": there is no output '" + output +
                                    "'; 'out' names the out parameters");
        }
        Expectation expectation;
        expectation.output = output;
        if (oracle != nullptr) {
            ETALON_TRY(truth, ReadTruth(output, *oracle));
            expectation.truth = std::move(truth);
        }
        const bool by_output = std::any_of(
            rules.begin(), rules.end(), [](const auto& entry) { return entry.second.is_table(); });
        const toml::table* rule = &rules;
        if (by_output) {
            const toml::node* own = rules.get(output);
            if (own == nullptr) {
                return reader_.Fail(rules, "'accept' for '" + output + "' is missing");
            }
            ETALON_TRY(table, reader_.Table(*own, "'accept' for '" + output + "'"));
            rule = table;
        }
        // A rule that stands in no file is told of by its oracle's place.
        expectation.place =
            reader_.PlaceOf(rule->source().begin || oracle == nullptr ? *rule : *oracle);
        if (rule->contains("spec")) {
            ETALON_TRY(spec, ReadSpec(reader_, *rule));
            expectation.spec = spec;
        } else {
            ETALON_TRY(accept, ReadAcceptance(reader_, *rule));
            expectation.accept = accept;
        }
        case_.expectations.push_back(std::move(expectation));
        return Ok();
    }

    Result<Expression> ReadTruth(const std::string& output, const toml::node& node) {
        ETALON_TRY(truth, reader_.Formula(node, "'oracle'"));
        const auto bound = truth.Bind(SymbolsOf(case_.domains.front()));
        if (!bound) {
            return reader_.FailInside(node, bound.error());
        }
        if (case_.out.contains(output)) {
            const auto columns = ColumnsOf(output, case_.out.at(output))->size();
            if (columns != *bound) {
                return reader_.Fail(node, "'oracle' for '" + output + "' has " +
                                              std::to_string(*bound) + " components, not " +
                                              std::to_string(columns));
            }
        }
        return std::move(truth);
    }

    Status<> ReadLaws() {
        ETALON_TRY(tables, Tables("law"));
        for (const toml::table* table : tables) {
            ETALON_TRY(law, ReadLaw(reader_, *table));
            for (const Law& other : case_.laws) {
                if (other.name == law.name) {
                    return reader_.Fail(*table, "two laws are called '" + law.name + "'");
                }
            }
            case_.laws.push_back(law);
        }
        return Ok();
    }

    const TomlReader& reader_;
    const toml::table& table_;
    Purpose purpose_;
    Case case_;
};

}  // namespace

Result<Case> ReadCaseKeys(const TomlReader& reader, const toml::table& keys, Purpose purpose) {
    return CaseReader(reader, keys, purpose).Read();
}

Result<Case> ReadCase(const std::filesystem::path& root, const std::string& path) {
    const std::filesystem::path file = FileOf(root, path);
    ETALON_TRY(keys, ReadKeys(root, file));
    const TomlReader reader(file.string());
    ETALON_TRY(read, ReadCaseKeys(reader, keys.table, Purpose::kJudge));
    read.path = path;
    read.like = keys.like;
    read.file = file;
    read.root = root;
    return std::move(read);
}

void TakeFullCounts(Case& deep) {
    for (Domain& domain : deep.domains) {
        for (Input& input : domain.inputs) {
            input.count = std::max(input.count, input.full);
        }
    }
}

namespace {

// What the rows of an oracle leave a rule to refuse.
struct Refusable {
    std::uint64_t known = 0;      // rows at which there is a truth
    std::uint64_t refusable = 0;  // of these, where a value can be off
    std::uint64_t hits = 0;
    std::uint64_t placed = 0;  // hits whose tolerance ends before another hit begins
    bool can_fail = false;     // some single value, under a rule without shares

    void Add(const Acceptance& rule, const Expression::Value& truth) {
        if (std::isnan(truth.value)) {
            return;
        }
        ++known;
        if (!std::isfinite(truth.error)) {
            return;
        }
        can_fail = can_fail || !IsBlind(rule, truth.value, truth.error);
        ++refusable;
        if (truth.value >= 0) {
            ++hits;
            placed += rule.shares && rule.shares->beyond &&
                              Tolerance(rule, truth.value) < *rule.shares->beyond
                          ? 1
                          : 0;
        }
    }
};

// Why a rule with shares could refuse nothing; empty where it could.
std::string WhyBlind(const Shares& shares, const Refusable& rows) {
    const std::string of_rows = " of " + std::to_string(rows.known) + " rows";
    if (static_cast<double>(rows.refusable) <= shares.wrong * static_cast<double>(rows.known)) {
        return "a value can be off at " + std::to_string(rows.refusable) + of_rows +
               ", within the share that may be wrong";
    }
    if (shares.missed > 0 && rows.hits == 0) {
        return "'missed' has no hits to miss, the truth is one at none" + of_rows;
    }
    if (shares.beyond && rows.hits > 0 && rows.placed == 0) {
        return "the tolerance reaches as far as 'beyond' at all of " + std::to_string(rows.hits) +
               " hits";
    }
    return "";
}

}  // namespace

Status<> CheckAcceptance(const Case& checked, const Table& table) {
    constexpr std::uint64_t kBlock = 1024;
    for (const Expectation& expectation : checked.expectations) {
        if (!expectation.spec.empty()) {
            continue;  // no tolerance that could be too wide
        }
        Expression truth = *expectation.truth;
        const std::string where = expectation.place.Text();
        if (auto bound = truth.Bind(Symbols(table.variables)); !bound) {
            return Error{where + bound.error().message};
        }
        const Acceptance& accept = expectation.accept;
        Refusable refusable_rows;
        std::vector<Expression::Value> values;
        for (std::uint64_t first = 0;
             first < table.rows && (accept.shares || !refusable_rows.can_fail); first += kBlock) {
            const std::uint64_t rows = std::min(kBlock, table.rows - first);
            const auto numbers = Numbers(table, first, rows);
            std::vector<const double*> columns;
            for (const auto& column : numbers) {
                columns.push_back(column.data());
            }
            truth.Evaluate(columns, rows, values);
            for (const Expression::Value& value : values) {
                refusable_rows.Add(accept, value);
            }
        }
        if (refusable_rows.known == 0) {
            return Error{where + "the oracle for '" + expectation.output +
                         "' has no value at any of " + std::to_string(table.rows) + " rows"};
        }
        if (accept.shares) {
            if (const std::string why = WhyBlind(*accept.shares, refusable_rows); !why.empty()) {
                return Error{where + "nothing could fail: " + why};
            }
        } else if (!refusable_rows.can_fail) {
            return Error{where + "nothing could fail: " + accept.Text() +
                         " accepts 0, -truth, 2 truth and truth + 1 at all of " +
                         std::to_string(table.rows) + " rows"};
        }
    }
    return Ok();
}

Result<std::vector<std::string>> ListCases(const std::filesystem::path& root) {
    const std::filesystem::path folder = root / "cases";
    std::error_code code;
    std::filesystem::recursive_directory_iterator at(folder, code);
    std::vector<std::string> paths;
    for (; !code && at != std::filesystem::recursive_directory_iterator(); at.increment(code)) {
        if (at->is_regular_file() && at->path().extension() == ".toml" && !IsPart(at->path()) &&
            !IsFamily(at->path())) {
            paths.push_back(
                at->path().lexically_relative(folder).replace_extension().generic_string());
        }
    }
    if (code) {
        return Error{folder.string() + ": " + code.message()};
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace etalon
