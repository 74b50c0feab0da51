#include "case/read_domain.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "case/input_values.h"

namespace etalon {
namespace {

class InputReader {
  public:
    InputReader(const TomlReader& reader, const std::string& name, const toml::table& table)
        : reader_(reader), table_(table), what_("input '" + name + "'") {
        input_.name = name;
        input_.line = TomlReader::Line(table);
    }

    Result<Input> Read() {
        if (!IsIdentifier(input_.name)) {
            return reader_.Fail(table_, what_ + ": not a GLSL name");
        }
        if (IsReservedName(input_.name)) {
            return reader_.Fail(table_, what_ + ": a constant of expressions has this name");
        }
        ETALON_TRY_STEP(reader_.OnlyKeys(table_, {"type", "values", "range", "sample", "against",
                                                  "count", "full", "edges", "expr"}));
        ETALON_TRY_STEP(ReadSample());
        ETALON_TRY_STEP(ReadType());
        ETALON_TRY_STEP(ReadValues());
        ETALON_TRY_STEP(ReadRange());
        ETALON_TRY_STEP(ReadRest());
        ETALON_TRY_STEP(CheckSource());
        return input_;
    }

  private:
    bool IsDirection() const { return input_.sample == "sphere" || input_.sample == "hemisphere"; }
    // Whose sample stands by itself, without a range.
    bool IsSource() const { return IsDirection() || input_.sample == "any"; }
    Error Fail(const std::string& reason) const {
        return reader_.Fail(table_, what_ + ": " + reason);
    }
    std::string What(std::string_view key) const { return what_ + ": '" + std::string(key) + "'"; }

    Status<> ReadSample() {
        const toml::node* node = table_.get("sample");
        if (node == nullptr) {
            return Ok();
        }
        ETALON_TRY(sample, reader_.Text(*node, What("sample")));
        input_.sample = sample;
        constexpr std::string_view kKnown[] = {"bits",   "linear",     "log",
                                               "sphere", "hemisphere", "any"};
        if (std::find(std::begin(kKnown), std::end(kKnown), sample) == std::end(kKnown)) {
            return reader_.Fail(
                *node, What("sample") + " must be bits, linear, log, sphere, hemisphere or any");
        }
        return Ok();
    }

    Status<> ReadType() {
        if (IsDirection()) {
            input_.type = "vec3";
        }
        if (const toml::node* node = table_.get("type")) {
            ETALON_TRY(type, reader_.Text(*node, What("type")));
            input_.type = type;
            if (auto shape = ShapeOf(type); !shape) {
                return reader_.Fail(*node, what_ + ": " + shape.error().message);
            }
        }
        if (IsDirection() && input_.type != "vec2" && input_.type != "vec3") {
            return Fail("a direction has type vec2 or vec3");
        }
        shape_ = *ShapeOf(input_.type);
        return Ok();
    }

    Status<> ReadValues() {
        const toml::node* node = table_.get("values");
        if (node == nullptr) {
            return Ok();
        }
        ETALON_TRY(list, reader_.List(*node, What("values")));
        if (list->empty()) {
            return reader_.Fail(*node, What("values") + " is empty: the domain has no rows");
        }
        for (const toml::node& entry : *list) {
            std::vector<double> value;
            const toml::array* components = entry.as_array();
            if (shape_.size() > 1 && components == nullptr) {
                return reader_.Fail(entry, What("values") + " must be lists of " +
                                               std::to_string(shape_.size()) + " numbers");
            }
            if (components != nullptr) {
                for (const toml::node& component : *components) {
                    ETALON_TRY(number, reader_.Number(component, What("values")));
                    value.push_back(number);
                }
            } else {
                ETALON_TRY(number, reader_.Number(entry, What("values")));
                value.push_back(number);
            }
            Input one = input_;
            one.values = {value};
            if (auto words = OwnValues(one, 0, false); !words && !IsSource()) {
                return reader_.Fail(entry, what_ + ": " + words.error().message);
            }
            input_.values.push_back(std::move(value));
        }
        return Ok();
    }

    Status<> ReadRange() {
        const toml::node* node = table_.get("range");
        if (node == nullptr) {
            return Ok();
        }
        ETALON_TRY(list, reader_.List(*node, What("range")));
        if (list->size() != 2) {
            return reader_.Fail(*node, What("range") + " must be [low, high]");
        }
        ETALON_TRY(low, reader_.Number((*list)[0], What("range")));
        ETALON_TRY(high, reader_.Number((*list)[1], What("range")));
        input_.range = std::pair(low, high);
        Input probe = input_;
        if (auto words = OwnValues(probe, 0, false); !words && !IsSource()) {
            return reader_.Fail(*node, what_ + ": " + words.error().message);
        }
        return Ok();
    }

    Status<> ReadRest() {
        if (const toml::node* node = table_.get("count")) {
            ETALON_TRY(count, reader_.Count(*node, What("count")));
            input_.count = count;
            if (count > (1u << 24)) {
                return reader_.Fail(*node, What("count") + " is more than 2^24");
            }
        }
        if (const toml::node* node = table_.get("full")) {
            ETALON_TRY(full, reader_.Count(*node, What("full")));
            input_.full = full;
            if (full < input_.count || full == 0 || full > (1u << 24)) {
                return reader_.Fail(*node, What("full") + " must be from 'count' to 2^24");
            }
        }
        if (const toml::node* node = table_.get("against")) {
            ETALON_TRY(against, reader_.Text(*node, What("against")));
            input_.against = against;
        }
        if (const toml::node* node = table_.get("expr")) {
            ETALON_TRY(expression, reader_.Formula(*node, What("expr")));
            input_.expr = expression;
        }
        if (const toml::node* node = table_.get("edges")) {
            ETALON_TRY(list, reader_.List(*node, What("edges")));
            for (const toml::node& entry : *list) {
                ETALON_TRY(edge, reader_.Formula(entry, What("edges")));
                input_.edges.push_back(edge);
            }
            if (input_.type != "float") {
                return reader_.Fail(*node, What("edges") + " need type float");
            }
        }
        return Ok();
    }

    // Exactly one of values, range, a sample of its own and expr; and nothing that it has no use
    // for.
    Status<> CheckSource() const {
        const int sources = (input_.values.empty() ? 0 : 1) + (input_.range ? 1 : 0) +
                            (IsSource() ? 1 : 0) + (input_.expr ? 1 : 0);
        if (sources != 1) {
            return Fail(
                "needs exactly one of values, range, sample = \"sphere\", \"hemisphere\" or "
                "\"any\", and "
                "expr");
        }
        if ((input_.sample == "hemisphere") != !input_.against.empty()) {
            return Fail("'against' belongs to sample = \"hemisphere\"");
        }
        const bool draws = input_.range || IsSource();
        if (!draws &&
            (table_.contains("count") || table_.contains("full") || table_.contains("sample"))) {
            return Fail(
                "'count', 'full' and 'sample' belong to a range, a direction or sample = \"any\"");
        }
        if (!input_.edges.empty() && (input_.expr || IsSource())) {
            return Fail("'edges' belong to values or a range");
        }
        if (draws && input_.count == 0 && input_.edges.empty()) {
            return Fail(table_.contains("count") ? "'count' is 0: the domain has no rows"
                                                 : "'count' is missing");
        }
        return Ok();
    }

    const TomlReader& reader_;
    const toml::table& table_;
    std::string what_;
    Input input_;
    TypeShape shape_;
};

}  // namespace

bool IsIdentifier(const std::string& name) {
    return !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
           std::all_of(name.begin(), name.end(), [](unsigned char c) {
               return c == '_' || (c < 128 && std::isalnum(c) != 0);
           });
}

Result<bool> ReadCombine(const TomlReader& reader, const toml::node& node) {
    ETALON_TRY(combine, reader.Text(node, "'combine'"));
    if (combine != "product" && combine != "zip") {
        return reader.Fail(node, "'combine' must be product or zip");
    }
    return combine == "zip";
}

std::vector<Symbol> SymbolsOf(const Domain& domain) {
    std::vector<Symbol> symbols;
    for (const Input& input : domain.inputs) {
        symbols.push_back({input.name, ShapeOf(input.type)->size()});
    }
    return symbols;
}

Status<> CheckExpression(const TomlReader& reader, const toml::node& node,
                         const Expression& expression, std::span<const Symbol> symbols,
                         unsigned components) {
    Expression copy = expression;
    const auto bound = copy.Bind(symbols);
    if (!bound) {
        return reader.FailInside(node, bound.error());
    }
    if (*bound != components) {
        return reader.Fail(node, "'" + copy.text() + "' has " + std::to_string(*bound) +
                                     " components, not " + std::to_string(components));
    }
    return Ok();
}

Result<Domain> ReadDomain(const TomlReader& reader, const toml::table& table,
                          const DomainDefaults& defaults) {
    Domain domain;
    domain.file = reader.PlaceOf(table).file;
    domain.line = TomlReader::Line(table);
    domain.zip = defaults.zip;
    std::vector<const toml::node*> conditions;
    if (defaults.where != nullptr) {
        conditions.push_back(defaults.where);
    }
    std::vector<const toml::table*> tables;
    for (const auto& [key, node] : TomlReader::InOrder(table)) {
        if (key == "combine" && node->is_string()) {
            ETALON_TRY(zip, ReadCombine(reader, *node));
            domain.zip = zip;
        } else if (key == "where" && node->is_string()) {
            conditions.push_back(node);
        } else if (!node->is_table()) {
            return reader.Fail(*node,
                               "input '" + key + "' must be a table, such as { values = [1] }");
        } else {
            ETALON_TRY(input, InputReader(reader, key, *node->as_table()).Read());
            domain.inputs.push_back(input);
            tables.push_back(node->as_table());
        }
    }
    if (domain.inputs.empty()) {
        return reader.Fail(table, "the domain has no inputs");
    }
    const std::vector<Symbol> symbols = SymbolsOf(domain);
    std::string where;
    for (const toml::node* node : conditions) {
        ETALON_TRY(condition, reader.Formula(*node, "'where'"));
        ETALON_TRY_STEP(CheckExpression(reader, *node, condition, symbols, 1));
        where += (where.empty() ? "(" : " && (") + condition.text() + ")";
    }
    if (!where.empty()) {
        ETALON_TRY(joined, Expression::Parse(where));
        domain.where = joined;
    }
    for (std::size_t k = 0; k < tables.size(); ++k) {
        const Input& input = domain.inputs[k];
        if (input.expr) {
            ETALON_TRY_STEP(CheckExpression(reader, *tables[k]->get("expr"), *input.expr, symbols,
                                            ShapeOf(input.type)->size()));
        }
        for (std::size_t e = 0; e < input.edges.size(); ++e) {
            const toml::node& node = *tables[k]->get("edges")->as_array()->get(e);
            ETALON_TRY_STEP(CheckExpression(reader, node, input.edges[e], symbols, 1));
        }
        const bool against_known =
            input.against.empty() ||
            std::any_of(domain.inputs.begin(), domain.inputs.end(), [&input](const Input& other) {
                return other.name == input.against && other.type == input.type;
            });
        if (!against_known) {
            return reader.Fail(*tables[k]->get("against"),
                               "there is no input '" + input.against + "' of type " + input.type);
        }
    }
    return domain;
}

}  // namespace etalon
