#include "map/map_plan.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "base/format.h"
#include "case/input_values.h"
#include "case/read_map.h"
#include "compile/compile.h"
#include "numeric/ulp.h"
#include "run/given.h"
#include "run/observe.h"

namespace etalon {
namespace {

std::vector<std::string> Split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t end = std::min(text.find(separator, from), text.size());
        parts.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return parts;
}

std::string NameOf(const JudgedColumn& column) {
    return column.name.substr(0, column.name.find_first_of(".["));
}

// A place in the range, 0 to 1 from end to end.
double At(const MapRange& range, double part) {
    return range.is_log ? range.low * std::pow(range.high / range.low, part)
                        : range.low + (range.high - range.low) * part;
}

class Planner {
  public:
    Planner(const Case& source, const MapScope& scope) : source_(source), scope_(scope) {}

    Result<MapPlan> Run() {
        ETALON_TRY_STEP(CheckRules());
        ETALON_TRY_STEP(ChooseAxes());
        ETALON_TRY_STEP(ReadAt());
        ETALON_TRY_STEP(FixOthers());
        ETALON_TRY_STEP(FindLeftOut());
        ETALON_TRY(table, Expand({plan_.domain}, source_.seed));
        ETALON_TRY(prepared, PrepareRows(source_, std::move(table)));
        plan_.prepared = std::move(prepared);
        ETALON_TRY_STEP(Narrow());
        ETALON_TRY_STEP(PrepareSpent());
        plan_.fixed = FixedText();
        return std::move(plan_);
    }

  private:
    Error Fail(const std::string& reason) const { return Error{source_.path + ": " + reason}; }

    Status<> CheckRules() const {
        for (const Expectation& expectation : source_.expectations) {
            if (!expectation.spec.empty()) {
                return Error{expectation.place.Text() +
                             "a map judges by an oracle or a law, not by a specification"};
            }
        }
        return Ok();
    }

    Status<> ChooseAxes() {
        std::string x;
        std::string y;
        CaseMap map = source_.map.value_or(CaseMap{});
        if (!scope_.over.empty()) {
            const std::vector<std::string> names = Split(scope_.over, ',');
            if (names.size() != 2 || names[0] == names[1]) {
                return Error{"--over '" + scope_.over + "': it reads X,Y, two inputs"};
            }
            for (const std::string& name : names) {
                if (const std::string why = WhyNoAxis(source_.domains, name); !why.empty()) {
                    return Error{"--over: " + why};
                }
            }
            x = names[0];
            y = names[1];
        } else if (source_.map) {
            x = map.x;
            y = map.y;
        } else {
            return Fail("has no [map]; --over X,Y names the two inputs of one");
        }
        ETALON_TRY_STEP(ReadSize(map));
        for (const std::string& text : scope_.ranges) {
            ETALON_TRY_STEP(ReadRange(text, x, y, map.ranges));
        }
        ETALON_TRY(x_axis, AxisOf(x, map.width, map.ranges));
        ETALON_TRY(y_axis, AxisOf(y, map.height, map.ranges));
        plan_.x = x_axis;
        plan_.y = y_axis;
        return Ok();
    }

    Status<> ReadSize(CaseMap& map) const {
        if (scope_.size.empty()) {
            return Ok();
        }
        const char* const end = scope_.size.data() + scope_.size.size();
        const auto width = std::from_chars(scope_.size.data(), end, map.width);
        if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
            const auto height = std::from_chars(width.ptr + 1, end, map.height);
            if (height.ec == std::errc() && height.ptr == end && map.width >= 1 &&
                map.height >= 1 && std::max(map.width, map.height) <= kMostMapCells) {
                return Ok();
            }
        }
        return Error{format("--size '{}': it reads WIDTHxHEIGHT, each from 1 to {}", scope_.size,
                            kMostMapCells)};
    }

    // "X=1e-6:1:log"
    static Status<> ReadRange(const std::string& text, const std::string& x, const std::string& y,
                              std::map<std::string, MapRange>& ranges) {
        const auto fail = [&](const std::string& reason) {
            return Error{"--range '" + text + "': " + reason};
        };
        const std::size_t equals = text.find('=');
        const std::vector<std::string> parts = equals == std::string::npos
                                                   ? std::vector<std::string>{}
                                                   : Split(text.substr(equals + 1), ':');
        if (parts.size() < 2 || parts.size() > 3) {
            return fail("it reads NAME=LOW:HIGH or NAME=LOW:HIGH:log");
        }
        const std::string name = text.substr(0, equals);
        if (name != x && name != y) {
            return fail("the map is over '" + x + "' and '" + y + "'");
        }
        MapRange range;
        for (const auto& [part, end] : {std::pair(parts[0], &range.low), {parts[1], &range.high}}) {
            const Result<std::uint32_t> word = ParseWord(Scalar::kFloat, part);
            if (!word) {
                return fail(word.error().message);
            }
            *end = FromBits(*word);
        }
        if (parts.size() == 3) {
            if (parts[2] != "log" && parts[2] != "linear") {
                return fail("the scale is linear or log");
            }
            range.is_log = parts[2] == "log";
        }
        if (const std::string why = WhyNoRange(range); !why.empty()) {
            return fail(why);
        }
        ranges[name] = range;
        return Ok();
    }

    Result<MapAxis> AxisOf(const std::string& name, std::uint32_t count,
                           const std::map<std::string, MapRange>& ranges) const {
        const auto given = ranges.find(name);
        const std::optional<MapRange> range = given != ranges.end()
                                                  ? std::optional(given->second)
                                                  : OwnMapRange(source_.domains, name);
        if (!range) {
            return Fail("'" + name + "' has no range; --range '" + name + "=LOW:HIGH' gives one");
        }
        if (const std::string why = WhyNoRange(*range); !why.empty()) {
            return Fail("'" + name + "': " + why);
        }
        const std::vector<Input>& inputs = source_.domains[0].inputs;
        const auto input = std::find_if(inputs.begin(), inputs.end(),
                                        [&](const Input& one) { return one.name == name; });
        if (!IsWhole(input->type)) {
            return MakeMapAxis(name, *range, count);
        }
        const auto [least, greatest] =
            input->type == "int" ? std::pair(-0x1p31, 0x1p31 - 1) : std::pair(0.0, 0x1p32 - 1);
        if (range->low < least || range->high > greatest) {
            return Fail(format("'{}': the range is not one of type {}", name, input->type));
        }
        if (std::ceil(range->low) > std::floor(range->high)) {
            return Fail("'" + name + "': the range holds no whole number");
        }
        return MakeWholeMapAxis(name, *range, count);
    }

    // What the user gives goes before what the [map] gives.
    Status<> ReadAt() {
        for (const Input& input : source_.domains[0].inputs) {
            const auto own = ColumnsOf(input.name, input.type);
            if (!own) {
                return Fail(own.error().message);
            }
            columns_.insert(columns_.end(), own->begin(), own->end());
            owners_.resize(columns_.size(), input.name);
        }
        given_.resize(columns_.size());
        if (source_.map && !source_.map->at.empty()) {
            constexpr std::string_view kOption = "--at";
            const auto own = ReadGiven(columns_, source_.map->at);
            if (!own) {
                return Error{source_.map->at_place.Text() + "'at'" +
                             own.error().message.substr(kOption.size())};
            }
            given_ = *own;
        }
        ETALON_TRY(more, ReadGiven(columns_, scope_.at));
        for (std::size_t c = 0; c < columns_.size(); ++c) {
            if (more[c]) {
                given_[c] = more[c];
            }
            if (!given_[c] || (owners_[c] != plan_.x.name && owners_[c] != plan_.y.name)) {
                continue;
            }
            if (more[c]) {
                return Error{"--at: the map is over '" + owners_[c] + "'"};
            }
            if (scope_.over.empty()) {
                return Error{source_.map->at_place.Text() + "'at': the map is over '" + owners_[c] +
                             "'"};
            }
        }
        return Ok();
    }

    // All rows side by side, a cell each.
    Status<> FixOthers() {
        const auto has_range = [](const Domain& domain, const std::string& name) {
            return std::any_of(domain.inputs.begin(), domain.inputs.end(), [&](const Input& one) {
                return one.name == name && one.range.has_value();
            });
        };
        const auto ranged =
            std::find_if(source_.domains.begin(), source_.domains.end(), [&](const Domain& one) {
                return has_range(one, plan_.x.name) && has_range(one, plan_.y.name);
            });
        plan_.domain = ranged == source_.domains.end() ? source_.domains[0] : *ranged;
        plan_.domain.zip = true;
        for (Input& input : plan_.domain.inputs) {
            ETALON_TRY(held, Held(input));
            input = held;
        }
        return Ok();
    }

    Result<Input> Held(const Input& input) const {
        Input held;
        held.name = input.name;
        held.type = input.type;
        held.line = input.line;
        if (input.name == plan_.x.name || input.name == plan_.y.name) {
            const std::size_t width = plan_.x.values.size();
            for (std::size_t cell = 0; cell < plan_.cells(); ++cell) {
                held.values.push_back({input.name == plan_.x.name ? plan_.x.values[cell % width]
                                                                  : plan_.y.values[cell / width]});
            }
            return held;
        }
        std::vector<std::optional<std::uint32_t>> given;
        for (std::size_t c = 0; c < columns_.size(); ++c) {
            if (owners_[c] == input.name) {
                given.push_back(given_[c]);
            }
        }
        const auto is_given = [](const auto& word) { return word.has_value(); };
        if (!std::all_of(given.begin(), given.end(), is_given)) {
            if (input.expr || input.sample == "hemisphere") {
                if (std::any_of(given.begin(), given.end(), is_given)) {
                    return Error{"at: '" + input.name +
                                 "' follows other inputs; give all of its components or none"};
                }
                held.expr = input.expr;
                if (!input.expr) {
                    ETALON_TRY(opposite, Expression::Parse("-normalize(" + input.against + ")"));
                    held.expr = opposite;
                }
                return held;
            }
            const auto own = OwnValues(input, source_.seed, false);
            if (!own) {
                return Error{Place{plan_.domain.file, input.line}.Text() + "input '" + input.name +
                             "': " + own.error().message};
            }
            for (std::size_t k = 0; k < given.size(); ++k) {
                given[k] = given[k] ? given[k] : std::optional(own->words[k]);
            }
        }
        const Scalar scalar = ShapeOf(input.type)->scalar;
        std::vector<double> value;
        for (const auto& word : given) {
            value.push_back(WordValue(scalar, *word));
        }
        held.values = {value};
        return held;
    }

    Status<> FindLeftOut() {
        const std::optional<Expression> where = plan_.domain.where;
        plan_.domain.where.reset();
        plan_.left_out.assign(plan_.cells(), false);
        if (!where) {
            return Ok();
        }
        ETALON_TRY(table, Expand({plan_.domain}, source_.seed));
        Expression condition = *where;
        ETALON_TRY(components, condition.Bind(Symbols(table.variables)));
        ETALON_CHECK(components == 1);
        const auto numbers = Numbers(table, 0, table.rows);
        std::vector<const double*> pointers;
        for (const std::vector<double>& column : numbers) {
            pointers.push_back(column.data());
        }
        std::vector<Expression::Value> values;
        condition.Evaluate(pointers, table.rows, values);
        for (std::size_t cell = 0; cell < values.size(); ++cell) {
            plan_.left_out[cell] = values[cell].value == 0 || std::isnan(values[cell].value);
        }
        if (std::find(plan_.left_out.begin(), plan_.left_out.end(), false) ==
            plan_.left_out.end()) {
            return Fail("'where' refuses every cell of the map");
        }
        return Ok();
    }

    // Keeps the outputs, or the one law, that are mapped.
    Status<> Narrow() {
        PreparedCase& prepared = plan_.prepared;
        std::string wanted = scope_.output;
        std::string where = "--output";
        if (wanted.empty() && source_.map && !source_.map->output.empty()) {
            wanted = source_.map->output;
            where = source_.map->output_place.Text() + "'output'";
        }
        std::vector<JudgedColumn> judged;
        std::size_t at = 0;
        for (const Expectation& expectation : source_.expectations) {
            MapPlan::Oracle oracle = {*expectation.truth, {}};
            for (unsigned k = 0;
                 at < prepared.judged.size() && NameOf(prepared.judged[at]) == expectation.output;
                 ++k, ++at) {
                JudgedColumn& column = prepared.judged[at];
                if (wanted.empty() || wanted == column.name || wanted == expectation.output) {
                    if (column.scalar == Scalar::kFloat) {
                        oracle.components.push_back(k);
                    }
                    judged.push_back(std::move(column));
                }
            }
            if (!oracle.components.empty()) {
                plan_.oracles.push_back(std::move(oracle));
            }
        }
        if (!judged.empty()) {
            prepared.judged = std::move(judged);
            prepared.laws.clear();
            return Ok();
        }
        std::string names;
        for (const JudgedColumn& column : prepared.judged) {
            names += (names.empty() ? "'" : ", '") + column.name + "'";
        }
        std::vector<PreparedLaw> laws;
        for (PreparedLaw& law : prepared.laws) {
            names += (names.empty() ? "'" : ", '") + law.law.name + "'";
            if (wanted.empty() || wanted == law.law.name) {
                laws.push_back(std::move(law));
            }
        }
        if (laws.empty()) {
            return Error{where + ": the case judges no '" + wanted + "'; it judges " + names};
        }
        prepared.judged.clear();
        prepared.laws = std::move(laws);
        return Ok();
    }

    Status<> PrepareSpent() {
        if (!source_.map || source_.map->spent.empty()) {
            return Ok();
        }
        SpentCall spent;
        const std::string origin = source_.map->spent_place.Text() + "spent";
        spent.call = plan_.prepared.call;
        spent.call.wanted = {{"spent", source_.map->spent, origin}};
        std::erase_if(spent.call.arguments,
                      [](const Argument& argument) { return !argument.is_input; });
        for (Argument& argument : spent.call.arguments) {
            argument.is_output = false;
        }
        ETALON_TRY(signature, Inspect(spent.call));
        spent.signature = signature;
        const std::vector<ProbeColumn> outputs = OutputColumns(spent.call, signature);
        if (outputs.size() != 1 || outputs[0].scalar != Scalar::kBool) {
            return Error{origin + ": the value is no bool"};
        }
        plan_.spent = std::move(spent);
        return Ok();
    }

    std::string FixedText() const {
        std::string text;
        const Table& table = plan_.prepared.table;
        for (const Input& input : plan_.domain.inputs) {
            if (input.expr || input.values.size() > 1 || input.name == plan_.x.name ||
                input.name == plan_.y.name) {
                continue;
            }
            for (std::size_t c = 0; c < columns_.size(); ++c) {
                if (owners_[c] != input.name) {
                    continue;
                }
                const auto same =
                    std::find_if(table.columns.begin(), table.columns.end(),
                                 [&](const Column& one) { return one.name == columns_[c].name; });
                ETALON_CHECK(same != table.columns.end());
                const auto at = static_cast<std::size_t>(same - table.columns.begin());
                text += (text.empty() ? "" : ", ") + columns_[c].name + "=" +
                        ExactText(columns_[c].scalar, table.At(0, at));
            }
        }
        return text;
    }

    const Case& source_;
    const MapScope& scope_;
    std::vector<Column> columns_;  // of the first domain's inputs
    std::vector<std::string> owners_;
    std::vector<std::optional<std::uint32_t>> given_;
    MapPlan plan_;
};

}  // namespace

MapAxis MakeMapAxis(const std::string& name, const MapRange& range, std::uint32_t count) {
    MapAxis axis;
    axis.name = name;
    axis.is_log = range.is_log;
    for (std::uint32_t k = 0; k <= count; ++k) {
        axis.edges.push_back(k == count ? range.high : At(range, static_cast<double>(k) / count));
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        axis.values.push_back(static_cast<float>(At(range, (k + 0.5) / count)));
    }
    return axis;
}

MapAxis MakeWholeMapAxis(const std::string& name, const MapRange& range, std::uint32_t count) {
    MapAxis axis;
    axis.name = name;
    axis.is_log = range.is_log;
    axis.is_whole = true;
    const double low = std::ceil(range.low);
    const double high = std::floor(range.high);
    const MapRange cells = {low - 0.5, high + 0.5, range.is_log};
    axis.edges.push_back(cells.low);
    for (std::uint32_t k = 0; k < count; ++k) {
        const double value = std::clamp(std::round(At(cells, (k + 0.5) / count)), low, high);
        if (!axis.values.empty() && value == axis.values.back()) {
            continue;
        }
        if (!axis.values.empty()) {
            axis.edges.push_back((axis.values.back() + value) / 2);
        }
        axis.values.push_back(value);
    }
    axis.edges.push_back(cells.high);
    return axis;
}

Result<MapPlan> PlanMap(const Case& source, const MapScope& scope) {
    return Planner(source, scope).Run();
}

}  // namespace etalon
