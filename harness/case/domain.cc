#include "case/domain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "case/expression_functions.h"
#include "case/input_values.h"
#include "case/place.h"
#include "numeric/sampling.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr std::uint64_t kMostRows = 1u << 24;
constexpr std::size_t kBlock = 4096;

// Rows under construction: the columns of the inputs that are resolved already.
struct Grid {
    struct Entry {
        const Input* input;
        TypeShape shape;
        std::vector<std::vector<std::uint32_t>> columns;
    };
    std::vector<Entry> entries;
    std::uint64_t rows = 1;

    const Entry* Find(const std::string& name) const {
        for (const Entry& entry : entries) {
            if (entry.input->name == name) {
                return &entry;
            }
        }
        return nullptr;
    }
};

std::vector<std::string> Dependencies(const Input& input) {
    std::vector<std::string> names;
    const auto add = [&names](const Expression& expression) {
        for (const std::string& name : expression.Names()) {
            names.push_back(name);
        }
    };
    std::for_each(input.edges.begin(), input.edges.end(), add);
    if (input.expr) {
        add(*input.expr);
    }
    if (!input.against.empty()) {
        names.push_back(input.against);
    }
    return names;
}

class Expansion {
  public:
    Expansion(const Domain& domain, std::uint64_t seed) : domain_(domain), seed_(seed) {}

    Result<Grid> Run() {
        std::vector<const Input*> waiting;
        for (const Input& input : domain_.inputs) {
            waiting.push_back(&input);
        }
        if (domain_.zip) {
            ETALON_TRY_STEP(CountRows());
        }
        ETALON_TRY_STEP(FilterOnce());
        while (!waiting.empty()) {
            const auto ready =
                std::find_if(waiting.begin(), waiting.end(),
                             [this](const Input* input) { return IsReady(Dependencies(*input)); });
            if (ready == waiting.end()) {
                return Unresolved(waiting);
            }
            ETALON_TRY_STEP(Resolve(**ready));
            waiting.erase(ready);
            ETALON_TRY_STEP(FilterOnce());
        }
        if (domain_.where && !filtered_) {
            return Fail(domain_.line, "'where' mentions an input that does not exist");
        }
        return std::move(grid_);
    }

  private:
    Error Fail(int line, const std::string& reason) const {
        return Error{Place{domain_.file, line}.Text() + reason};
    }
    Error Fail(const Input& input, const std::string& reason) const {
        return Fail(input.line, "input '" + input.name + "': " + reason);
    }

    bool IsReady(const std::vector<std::string>& names) const {
        return std::all_of(names.begin(), names.end(),
                           [this](const std::string& name) { return grid_.Find(name) != nullptr; });
    }

    Error Unresolved(const std::vector<const Input*>& waiting) const {
        for (const Input* input : waiting) {
            for (const std::string& name : Dependencies(*input)) {
                if (std::none_of(domain_.inputs.begin(), domain_.inputs.end(),
                                 [&name](const Input& other) { return other.name == name; })) {
                    return Fail(*input, "'" + name + "' is no input");
                }
            }
        }
        if (waiting.size() == 1) {
            return Fail(*waiting[0], "depends on itself");
        }
        return Fail(*waiting[0], "depends on itself by way of '" + waiting[1]->name + "'");
    }

    std::uint64_t SeedOf(const Input& input) const { return Mix(seed_, input.name); }

    static bool HasOwnValues(const Input& input) {
        return !input.expr && input.sample != "hemisphere";
    }

    Result<ValueList> Own(const Input& input) const {
        auto list = OwnValues(input, SeedOf(input), domain_.zip);
        if (!list) {
            return Fail(input, list.error().message);
        }
        return list;
    }

    // Side by side: as many rows as the inputs with more than one value have values.
    Status<> CountRows() {
        const Input* first = nullptr;
        for (const Input& input : domain_.inputs) {
            if (!input.edges.empty()) {
                return Fail(input, "edges need every combination, not combine = \"zip\"");
            }
            if (!HasOwnValues(input)) {
                continue;
            }
            ETALON_TRY(list, Own(input));
            if (list.size() == 1) {
                continue;
            }
            if (first != nullptr && grid_.rows != list.size()) {
                return Fail(input, std::to_string(list.size()) + " values stand beside " +
                                       std::to_string(grid_.rows) + " of '" + first->name + "'");
            }
            first = &input;
            grid_.rows = list.size();
        }
        return Ok();
    }

    Status<> Resolve(const Input& input) {
        auto shape = ShapeOf(input.type);
        if (!shape) {
            return Fail(input, shape.error().message);
        }
        if (input.expr) {
            return Compute(input, *shape);
        }
        if (input.sample == "hemisphere") {
            return Oppose(input, *shape);
        }
        ETALON_TRY(list, Own(input));
        if (domain_.zip) {
            return Append(input, *shape, [&](std::uint64_t row, std::vector<std::uint32_t>& words) {
                const std::size_t at = list.size() == 1 ? 0 : row * list.components;
                const auto from = list.words.begin() + static_cast<std::ptrdiff_t>(at);
                words.assign(from, from + list.components);
            });
        }
        if (input.edges.empty()) {
            return Append(input, *shape, [&](std::uint64_t, std::vector<std::uint32_t>& words) {
                words = list.words;
            });
        }
        return WithEdges(input, *shape, list);
    }

    // Every row is followed by the values that `values_of` gives it (components together), each in
    // a row of its own.
    template <typename ValuesOf>
    Status<> Append(const Input& input, const TypeShape& shape, const ValuesOf& values_of) {
        std::vector<std::uint32_t> sources;
        Grid::Entry entry{&input, shape, {}};
        entry.columns.resize(shape.size());
        std::vector<std::uint32_t> words;
        for (std::uint64_t row = 0; row < grid_.rows; ++row) {
            values_of(row, words);
            const std::size_t values = words.size() / shape.size();
            if (sources.size() + values > kMostRows) {
                return Fail(input, "the domain has more than 2^24 rows");
            }
            for (std::size_t k = 0; k < values; ++k) {
                sources.push_back(static_cast<std::uint32_t>(row));
                for (unsigned c = 0; c < shape.size(); ++c) {
                    entry.columns[c].push_back(words[k * shape.size() + c]);
                }
            }
        }
        Select(sources);
        grid_.entries.push_back(std::move(entry));
        return Ok();
    }

    // Replaces the rows by the given ones.
    void Select(const std::vector<std::uint32_t>& sources) {
        for (Grid::Entry& entry : grid_.entries) {
            for (auto& column : entry.columns) {
                std::vector<std::uint32_t> selected(sources.size());
                for (std::size_t k = 0; k < sources.size(); ++k) {
                    selected[k] = column[sources[k]];
                }
                column = std::move(selected);
            }
        }
        grid_.rows = sources.size();
    }

    // Calls take(first, values) for block after block of rows; values by columns.
    template <typename Take>
    Status<> Evaluate(const Expression& unbound, unsigned components, int line,
                      const std::string& what, const Take& take) const {
        Expression expression = unbound;
        std::vector<Symbol> symbols;
        std::vector<std::pair<const std::vector<std::uint32_t>*, Scalar>> sources;
        for (const std::string& name : expression.Names()) {
            if (const Grid::Entry* entry = grid_.Find(name)) {
                symbols.push_back({name, entry->shape.size()});
                for (const auto& column : entry->columns) {
                    sources.emplace_back(&column, entry->shape.scalar);
                }
            }
        }
        const auto bound = expression.Bind(symbols);
        if (!bound) {
            return Fail(line, what + ": " + bound.error().message);
        }
        if (*bound != components) {
            return Fail(line, what + ": the value has " + std::to_string(*bound) +
                                  " components, not " + std::to_string(components));
        }
        std::vector<std::vector<double>> numbers(sources.size(), std::vector<double>(kBlock));
        std::vector<const double*> columns;
        for (const auto& column : numbers) {
            columns.push_back(column.data());
        }
        std::vector<Expression::Value> values;
        for (std::uint64_t first = 0; first < grid_.rows; first += kBlock) {
            const std::size_t rows = std::min<std::uint64_t>(kBlock, grid_.rows - first);
            for (std::size_t k = 0; k < sources.size(); ++k) {
                const auto& [words, scalar] = sources[k];
                for (std::size_t row = 0; row < rows; ++row) {
                    numbers[k][row] = WordValue(scalar, (*words)[first + row]);
                }
            }
            expression.Evaluate(columns, rows, values);
            take(first, rows, values);
        }
        return Ok();
    }

    Status<> Compute(const Input& input, const TypeShape& shape) {
        std::vector<std::uint32_t> words(grid_.rows * shape.size());
        std::string wrong;
        const auto keep = [&](std::uint64_t first, std::size_t rows, const auto& values) {
            for (std::size_t k = 0; k < values.size(); ++k) {
                const std::uint64_t row = first + k % rows;
                double value = values[k].value;
                if (shape.scalar == Scalar::kFloat) {
                    value = static_cast<float>(value);
                } else {
                    value = std::nearbyint(value);
                }
                if (auto word = WordOf(shape.scalar, value)) {
                    words[row * shape.size() + k / rows] = *word;
                } else if (wrong.empty()) {
                    wrong = word.error().message;
                }
            }
        };
        ETALON_TRY_STEP(
            Evaluate(*input.expr, shape.size(), input.line, "input '" + input.name + "'", keep));
        if (!wrong.empty()) {
            return Fail(input, wrong);
        }
        return Append(input, shape, [&](std::uint64_t row, std::vector<std::uint32_t>& out) {
            const auto from = words.begin() + static_cast<std::ptrdiff_t>(row * shape.size());
            out.assign(from, from + shape.size());
        });
    }

    Status<> Oppose(const Input& input, const TypeShape& shape) {
        const Grid::Entry& against = *grid_.Find(input.against);
        const std::size_t size = shape.size();
        if (against.input->type != input.type) {
            return Fail(input, "'" + input.against + "' is not of type " + input.type);
        }
        const std::uint64_t seed = SeedOf(input);
        return Append(input, shape, [&](std::uint64_t row, std::vector<std::uint32_t>& words) {
            float toward[3] = {};
            float vector[3] = {};
            for (std::size_t c = 0; c < size; ++c) {
                toward[c] = FromBits(against.columns[c][row]);
            }
            const std::uint64_t all = domain_.zip ? grid_.rows : input.count + kOpposedLandmarks;
            const std::uint64_t first = domain_.zip ? row : 0;
            const std::uint64_t last = domain_.zip ? row + 1 : all;
            words.clear();
            for (std::uint64_t k = first; k < last; ++k) {
                OpposedDirection({toward, size}, k, all, Mix(seed, row), {vector, size});
                for (std::size_t c = 0; c < size; ++c) {
                    words.push_back(ToBits(vector[c]));
                }
            }
        });
    }

    Status<> WithEdges(const Input& input, const TypeShape& shape, const ValueList& list) {
        if (shape.scalar != Scalar::kFloat || shape.size() != 1) {
            return Fail(input, "edges need type float");
        }
        constexpr double kEverything = std::numeric_limits<float>::max();
        const auto range = input.range.value_or(std::pair(-kEverything, kEverything));
        const auto low = static_cast<float>(range.first);
        const auto high = static_cast<float>(range.second);
        std::vector<std::vector<double>> edges(input.edges.size());
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const auto keep = [&](std::uint64_t, std::size_t, const auto& values) {
                for (const Expression::Value& value : values) {
                    edges[k].push_back(value.value);
                }
            };
            ETALON_TRY_STEP(
                Evaluate(input.edges[k], 1, input.line, "input '" + input.name + "'", keep));
        }
        std::vector<float> own;
        for (const std::uint32_t word : list.words) {
            own.push_back(FromBits(word));
        }
        return Append(input, shape, [&](std::uint64_t row, std::vector<std::uint32_t>& words) {
            std::vector<float> values = own;
            for (const std::vector<double>& edge : edges) {
                for (const float value : Neighbourhood(edge[row], low, high)) {
                    values.push_back(value);
                }
            }
            std::erase_if(values, [&](float v) { return std::isnan(v) && input.range; });
            words.clear();
            if (input.range) {
                SortUnique(values);
            }
            for (const float value : values) {
                if (input.range ||
                    std::find(words.begin(), words.end(), ToBits(value)) == words.end()) {
                    words.push_back(ToBits(value));
                }
            }
        });
    }

    // Leaves out the rows that `where` refuses, as soon as all that it mentions is resolved.
    Status<> FilterOnce() {
        if (!domain_.where || filtered_ || !IsReady(domain_.where->Names())) {
            return Ok();
        }
        filtered_ = true;
        std::vector<std::uint32_t> kept;
        const auto keep = [&](std::uint64_t first, std::size_t, const auto& values) {
            for (std::size_t row = 0; row < values.size(); ++row) {
                if (values[row].value != 0 && !std::isnan(values[row].value)) {
                    kept.push_back(static_cast<std::uint32_t>(first + row));
                }
            }
        };
        ETALON_TRY_STEP(Evaluate(*domain_.where, 1, domain_.line, "'where'", keep));
        if (kept.empty()) {
            return Fail(domain_.line, "the domain is empty: 'where' refuses every row");
        }
        Select(kept);
        return Ok();
    }

    const Domain& domain_;
    std::uint64_t seed_;
    Grid grid_;
    bool filtered_ = false;
};

}  // namespace

bool IsReservedName(const std::string& name) {
    return FindConstant(name) != nullptr;
}

Result<std::vector<Column>> ColumnsOf(const std::string& name, const std::string& type) {
    ETALON_TRY(shape, ShapeOf(type));
    std::vector<Column> columns;
    for (unsigned column = 0; column < shape.columns; ++column) {
        const std::string vector =
            shape.columns > 1 ? name + "[" + std::to_string(column) + "]" : name;
        for (unsigned row = 0; row < shape.rows; ++row) {
            const std::string component = shape.rows > 1 ? std::string(".") + "xyzw"[row] : "";
            columns.push_back({vector + component, shape.scalar});
        }
    }
    return columns;
}

std::vector<Symbol> Symbols(const std::vector<Variable>& variables) {
    std::vector<Symbol> symbols;
    for (const Variable& variable : variables) {
        symbols.push_back({variable.name, variable.columns});
    }
    return symbols;
}

std::vector<std::vector<double>> Numbers(const Table& table, std::uint64_t first,
                                         std::uint64_t rows) {
    ETALON_CHECK(first + rows <= table.rows);
    std::vector<std::vector<double>> numbers(table.columns.size(), std::vector<double>(rows));
    for (std::size_t column = 0; column < numbers.size(); ++column) {
        for (std::uint64_t row = 0; row < rows; ++row) {
            numbers[column][row] =
                WordValue(table.columns[column].scalar, table.At(first + row, column));
        }
    }
    return numbers;
}

Result<Table> Expand(const std::vector<Domain>& domains, std::uint64_t seed) {
    ETALON_CHECK(!domains.empty());
    Table table;
    for (const Input& input : domains[0].inputs) {
        const auto columns = ColumnsOf(input.name, input.type);
        if (!columns) {
            return Error{Place{domains[0].file, input.line}.Text() + columns.error().message};
        }
        table.variables.push_back({input.name, input.type,
                                   static_cast<std::uint32_t>(table.columns.size()),
                                   static_cast<std::uint32_t>(columns->size())});
        table.columns.insert(table.columns.end(), columns->begin(), columns->end());
    }
    std::vector<Grid> grids;
    for (const Domain& domain : domains) {
        // Each domain of a case draws samples of its own.
        ETALON_TRY(grid, Expansion(domain, Mix(seed, grids.size())).Run());
        const std::string where = Place{domain.file, domain.line}.Text();
        bool same = grid.entries.size() == table.variables.size();
        for (const Variable& variable : table.variables) {
            const Grid::Entry* entry = grid.Find(variable.name);
            same = same && entry != nullptr && entry->input->type == variable.type;
        }
        if (!same) {
            return Error{where + "this domain has not the same inputs as the first"};
        }
        if (grid.rows == 0) {
            return Error{where + "the domain is empty"};
        }
        table.rows += grid.rows;
        if (table.rows > kMostRows) {
            return Error{where + "the domains have more than 2^24 rows"};
        }
        grids.push_back(std::move(grid));
    }
    table.words.reserve(table.rows * table.columns.size());
    for (const Variable& variable : table.variables) {
        for (std::uint32_t component = 0; component < variable.columns; ++component) {
            for (const Grid& grid : grids) {
                const auto& column = grid.Find(variable.name)->columns[component];
                table.words.insert(table.words.end(), column.begin(), column.end());
            }
        }
    }
    return table;
}

}  // namespace etalon
