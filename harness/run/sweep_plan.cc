#include "run/sweep_plan.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/format.h"
#include "numeric/ulp.h"
#include "run/given.h"

namespace etalon {
namespace {

// Floats of the range at which the case is looked at before the sweep: whether its acceptance could
// fail at all.
constexpr std::int64_t kLooks = 32;
constexpr std::uint64_t kMostSettingsLooked = 1024;

bool IsSweepable(const Input& input) {
    return input.type == "float" && input.range.has_value();
}

const Input* Find(const Domain& domain, const std::string& name) {
    const auto found = std::find_if(domain.inputs.begin(), domain.inputs.end(),
                                    [&](const Input& input) { return input.name == name; });
    return found == domain.inputs.end() ? nullptr : &*found;
}

bool Mentions(const Expression& expression, const std::string& name) {
    const std::vector<std::string> names = expression.Names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Evenly from end to end.
std::vector<std::vector<double>> GridOf(const Input& input, std::uint64_t count) {
    const auto low = static_cast<float>(input.range->first);
    const auto high = static_cast<float>(input.range->second);
    std::vector<std::vector<double>> values;
    for (std::uint64_t k = 0; k < count; ++k) {
        const double part =
            count == 1 ? 0 : static_cast<double>(k) / static_cast<double>(count - 1);
        double value = 0;
        if (input.sample == "linear") {
            value = low + part * (static_cast<double>(high) - low);
        } else if (input.sample == "log") {
            value = low * std::pow(static_cast<double>(high) / low, part);
        } else {
            const auto first = OrderedBits(low);
            value = FromOrderedBits(
                first + std::llround(part * static_cast<double>(OrderedBits(high) - first)));
        }
        const auto rounded = static_cast<float>(value);
        if (values.empty() || values.back()[0] != rounded) {
            values.push_back({rounded});
        }
    }
    return values;
}

class Planner {
  public:
    Planner(const Case& source, const SweepScope& scope) : source_(source), scope_(scope) {}

    Result<SweepPlan> Run() {
        ETALON_TRY_STEP(CheckRules());
        ETALON_TRY_STEP(ReadAt());
        ETALON_TRY_STEP(ChooseInput());
        ETALON_TRY_STEP(ChooseRange());
        ETALON_TRY_STEP(FixOthers());
        ETALON_TRY(settings, Expand({domain_}, source_.seed));
        plan_.settings = std::move(settings);
        const auto& columns = plan_.settings.columns;
        plan_.swept = static_cast<std::size_t>(
            std::find_if(columns.begin(), columns.end(),
                         [&](const Column& column) { return column.name == name_; }) -
            columns.begin());
        ETALON_TRY_STEP(Look());
        plan_.fixed = FixedText();
        return std::move(plan_);
    }

  private:
    Error Fail(const std::string& reason) const { return Error{source_.path + ": " + reason}; }

    Status<> CheckRules() const {
        if (source_.expectations.empty()) {
            return Fail("has no oracle to sweep by, only laws");
        }
        for (const Expectation& expectation : source_.expectations) {
            if (!expectation.spec.empty()) {
                return Error{expectation.place.Text() +
                             "a sweep judges by an oracle and a tolerance, not by a specification"};
            }
            if (expectation.accept.shares) {
                return Error{expectation.place.Text() +
                             "a sweep judges every value by itself, not the share of those that "
                             "are off"};
            }
        }
        return Ok();
    }

    Status<> ReadAt() {
        std::vector<Column> columns;
        std::vector<const Input*> owners;  // of the columns
        for (const Input& input : source_.domains[0].inputs) {
            const auto own = ColumnsOf(input.name, input.type);
            if (!own) {
                return Fail(own.error().message);
            }
            columns.insert(columns.end(), own->begin(), own->end());
            owners.resize(columns.size(), &input);
        }
        ETALON_TRY(words, ReadGiven(columns, scope_.at));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (words[c]) {
                given_[owners[c]->name].push_back(WordValue(columns[c].scalar, *words[c]));
            }
        }
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (!words[c] && given_.contains(owners[c]->name)) {
                return Error{"--at: no value for input '" + columns[c].name + "'"};
            }
        }
        return Ok();
    }

    Status<> ChooseInput() {
        name_ = scope_.over;
        if (name_.empty()) {
            std::set<std::string> names;
            for (const Domain& domain : source_.domains) {
                for (const Input& input : domain.inputs) {
                    if (IsSweepable(input) && !given_.contains(input.name)) {
                        names.insert(input.name);
                    }
                }
            }
            if (names.size() != 1) {
                std::string all;
                for (const std::string& name : names) {
                    all += (all.empty() ? "'" : ", '") + name + "'";
                }
                return Fail(
                    names.empty()
                        ? "no float input has a range; --over NAME --from A --to B gives one"
                        : "the inputs " + all +
                              " have a range each; --over NAME says which is swept");
            }
            name_ = *names.begin();
        }
        const Input* const input = Find(source_.domains[0], name_);
        if (input == nullptr) {
            return Error{"--over: the case has no input '" + name_ + "'"};
        }
        if (input->type != "float") {
            return Error{"--over: '" + name_ + "' is of type " + input->type +
                         ", and floats are swept"};
        }
        if (given_.contains(name_)) {
            return Error{"--at: '" + name_ + "' is the input that is swept"};
        }
        const auto ranged =
            std::find_if(source_.domains.begin(), source_.domains.end(), [&](const Domain& domain) {
                const Input* const own = Find(domain, name_);
                return own != nullptr && IsSweepable(*own);
            });
        domain_ = ranged == source_.domains.end() ? source_.domains[0] : *ranged;
        return Ok();
    }

    static Result<std::uint32_t> EndOf(const char* option, const std::string& text) {
        Result<std::uint32_t> word = ParseWord(Scalar::kFloat, text);
        if (!word) {
            return Error{std::string(option) + ": " + word.error().message};
        }
        if (std::isnan(FromBits(*word))) {
            return Error{std::string(option) + ": a NaN has no place among the floats"};
        }
        return word;
    }

    Status<> ChooseRange() {
        const Input& input = *Find(domain_, name_);
        if (!input.range && (scope_.from.empty() || scope_.to.empty())) {
            return Fail("'" + name_ + "' has no range; --from and --to give one");
        }
        ETALON_TRY(from, scope_.from.empty()
                             ? Result(ToBits(static_cast<float>(input.range->first)))
                             : EndOf("--from", scope_.from));
        ETALON_TRY(to, scope_.to.empty() ? Result(ToBits(static_cast<float>(input.range->second)))
                                         : EndOf("--to", scope_.to));
        if (OrderedBits(FromBits(from)) > OrderedBits(FromBits(to))) {
            return Error{format("the range from {} to {} of '{}' is empty",
                                WordText(Scalar::kFloat, from), WordText(Scalar::kFloat, to),
                                name_)};
        }
        plan_.from = from;
        plan_.to = to;
        return Ok();
    }

    Status<> FixOthers() {
        const auto depends = [&](const std::string& what) {
            return Fail(what + " depends on '" + name_ + "', so that it cannot be swept alone");
        };
        if (domain_.where && Mentions(*domain_.where, name_)) {
            return depends("the condition 'where'");
        }
        const bool is_listed =
            domain_.zip && std::any_of(domain_.inputs.begin(), domain_.inputs.end(),
                                       [](const Input& one) { return one.values.size() > 1; });
        for (Input& input : domain_.inputs) {
            input.edges.clear();
            const auto given = given_.find(input.name);
            if (input.name == name_ || given != given_.end()) {
                Input held;
                held.name = input.name;
                held.type = input.type;
                held.line = input.line;
                held.values = {given == given_.end() ? std::vector<double>{FromBits(plan_.from)}
                                                     : given->second};
                input = held;
            } else if (input.expr && Mentions(*input.expr, name_)) {
                return depends("'" + input.name + "'");
            } else if (IsSweepable(input) && !domain_.zip) {
                input.values = GridOf(input, scope_.grid);
                input.range.reset();
                input.sample.clear();
            } else if (!is_listed) {
                input.count = scope_.grid;
            }
        }
        return Ok();
    }

    // Prepares the case at some floats of the range.
    Status<> Look() {
        const Table& settings = plan_.settings;
        const std::int64_t first = OrderedBits(FromBits(plan_.from));
        const std::int64_t last = OrderedBits(FromBits(plan_.to));
        const std::int64_t looks = std::min(kLooks, last - first);
        Table table = settings;
        const std::uint64_t rows = std::min(settings.rows, kMostSettingsLooked);
        table.rows = rows * static_cast<std::uint64_t>(looks + 1);
        table.words.clear();
        for (std::size_t column = 0; column < settings.columns.size(); ++column) {
            for (std::uint64_t row = 0; row < rows; ++row) {
                for (std::int64_t k = 0; k <= looks; ++k) {
                    const std::int64_t at = looks == 0 ? first : first + (last - first) / looks * k;
                    table.words.push_back(column == plan_.swept
                                              ? ToBits(FromOrderedBits(k == looks ? last : at))
                                              : settings.At(row, column));
                }
            }
        }
        ETALON_TRY_STEP(CheckAcceptance(source_, table));
        ETALON_TRY(prepared, PrepareRows(source_, std::move(table)));
        plan_.call = prepared.call;
        plan_.signature = prepared.signature;
        auto output = prepared.judged.begin();
        for (const Expectation& expectation : source_.expectations) {
            SweepPlan::Oracle oracle;
            oracle.expression = *expectation.truth;
            ETALON_TRY(components, oracle.expression.Bind(Symbols(settings.variables)));
            for (unsigned k = 0; k < components; ++k, ++output) {
                oracle.outputs.push_back(std::move(*output));
                oracle.outputs.back().truth = {};
            }
            plan_.oracles.push_back(std::move(oracle));
        }
        return Ok();
    }

    std::string FixedText() const {
        const Table& settings = plan_.settings;
        std::string text;
        for (std::size_t c = 0; c < settings.columns.size(); ++c) {
            if (c == plan_.swept) {
                continue;
            }
            std::set<std::uint32_t> words;
            for (std::uint64_t row = 0; row < settings.rows; ++row) {
                words.insert(settings.At(row, c));
            }
            const Column& column = settings.columns[c];
            text += (text.empty() ? "" : ", ") + column.name +
                    (words.size() == 1 ? "=" + ExactText(column.scalar, *words.begin())
                                       : format(": {} values", words.size()));
        }
        return text;
    }

    const Case& source_;
    const SweepScope& scope_;
    std::map<std::string, std::vector<double>> given_;
    std::string name_;
    Domain domain_;
    SweepPlan plan_;
};

}  // namespace

Result<SweepPlan> PlanSweep(const Case& source, const SweepScope& scope) {
    return Planner(source, scope).Run();
}

}  // namespace etalon
