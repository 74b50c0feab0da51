#include "map/condition.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace etalon {
namespace {

using Columns = std::vector<std::vector<double>>;

std::vector<const double*> Pointers(const Columns& columns) {
    std::vector<const double*> pointers;
    for (const std::vector<double>& column : columns) {
        pointers.push_back(column.data());
    }
    return pointers;
}

class Differences {
  public:
    explicit Differences(const MapPlan& plan)
        : plan_(plan),
          table_(plan.prepared.table),
          centre_(Numbers(table_, 0, table_.rows)),
          rows_(table_.rows) {
        Follow(centre_);
    }

    std::vector<double> Run() const {
        std::vector<double> worst(rows_, 0);
        for (const MapPlan::Oracle& oracle : plan_.oracles) {
            const Columns middle = Values(oracle, centre_);
            std::vector<double> sums(rows_ * middle.size(), 0);
            for (const MapAxis* const axis : {&plan_.x, &plan_.y}) {
                if (!axis->is_whole) {
                    AddTerms(oracle, middle, axis->name, sums);
                }
            }
            for (std::size_t k = 0; k < middle.size(); ++k) {
                for (std::uint64_t row = 0; row < rows_; ++row) {
                    const double f = middle[k][row];
                    const double sum = sums[k * rows_ + row];
                    const double condition = std::isnan(f) ? f : sum == 0 ? 0 : sum / std::fabs(f);
                    if (std::isnan(condition) || condition > worst[row]) {
                        worst[row] = condition;
                    }
                }
            }
        }
        return worst;
    }

  private:
    // Adds |x df/dx| for the input of that name.
    void AddTerms(const MapPlan::Oracle& oracle, const Columns& middle, const std::string& name,
                  std::vector<double>& sums) const {
        const auto variable = std::find_if(table_.variables.begin(), table_.variables.end(),
                                           [&](const Variable& one) { return one.name == name; });
        ETALON_CHECK(variable != table_.variables.end());
        const std::size_t column = variable->first_column;
        Columns low = centre_;
        Columns high = centre_;
        for (std::uint64_t row = 0; row < rows_; ++row) {
            const double step = std::fabs(centre_[column][row]) * 0x1p-18;
            low[column][row] -= step;
            high[column][row] += step;
        }
        Follow(low);
        Follow(high);
        const Columns below = Values(oracle, low);
        const Columns above = Values(oracle, high);
        for (std::size_t k = 0; k < middle.size(); ++k) {
            for (std::uint64_t row = 0; row < rows_; ++row) {
                const double x = centre_[column][row];
                const bool has_below = !std::isnan(below[k][row]);
                const bool has_above = !std::isnan(above[k][row]);
                const double rise =
                    (has_above ? above : middle)[k][row] - (has_below ? below : middle)[k][row];
                const double run = (has_above ? high : centre_)[column][row] -
                                   (has_below ? low : centre_)[column][row];
                if (x != 0) {
                    sums[k * rows_ + row] += run > 0 ? std::fabs(x * rise / run)
                                                     : std::numeric_limits<double>::quiet_NaN();
                }
            }
        }
    }

    // Computes the inputs that follow from others, in an order in which they can be.
    void Follow(Columns& columns) const {
        std::vector<const Input*> waiting;
        for (const Input& input : plan_.domain.inputs) {
            if (input.expr) {
                waiting.push_back(&input);
            }
        }
        while (!waiting.empty()) {
            const auto ready = std::find_if(waiting.begin(), waiting.end(), [&](const Input* one) {
                const std::vector<std::string> names = one->expr->Names();
                return std::none_of(names.begin(), names.end(), [&](const std::string& name) {
                    return std::any_of(waiting.begin(), waiting.end(),
                                       [&](const Input* other) { return other->name == name; });
                });
            });
            ETALON_CHECK(ready != waiting.end());  // Expand has resolved them
            Compute(**ready, columns);
            waiting.erase(ready);
        }
    }

    void Compute(const Input& input, Columns& columns) const {
        const auto variable =
            std::find_if(table_.variables.begin(), table_.variables.end(),
                         [&](const Variable& one) { return one.name == input.name; });
        Expression expression = *input.expr;
        const auto components = expression.Bind(Symbols(table_.variables));
        ETALON_CHECK(components && *components == variable->columns);
        std::vector<Expression::Value> values;
        expression.Evaluate(Pointers(columns), rows_, values);
        for (std::uint32_t k = 0; k < variable->columns; ++k) {
            const std::size_t column = variable->first_column + k;
            const bool is_float = table_.columns[column].scalar == Scalar::kFloat;
            for (std::uint64_t row = 0; row < rows_; ++row) {
                const double value = values[k * rows_ + row].value;
                columns[column][row] = is_float ? value : std::nearbyint(value);
            }
        }
    }

    // Of the mapped components.
    Columns Values(const MapPlan::Oracle& oracle, const Columns& inputs) const {
        Expression expression = oracle.expression;
        const auto components = expression.Bind(Symbols(table_.variables));
        ETALON_CHECK(components.ok());
        std::vector<Expression::Value> values;
        expression.Evaluate(Pointers(inputs), rows_, values);
        Columns chosen;
        for (const unsigned component : oracle.components) {
            chosen.emplace_back();
            for (std::uint64_t row = 0; row < rows_; ++row) {
                chosen.back().push_back(values[component * rows_ + row].value);
            }
        }
        return chosen;
    }

    const MapPlan& plan_;
    const Table& table_;
    Columns centre_;
    std::uint64_t rows_;
};

}  // namespace

std::vector<double> ConditionNumbers(const MapPlan& plan) {
    const bool has_float = !plan.x.is_whole || !plan.y.is_whole;
    return plan.oracles.empty() || !has_float ? std::vector<double>() : Differences(plan).Run();
}

}  // namespace etalon
