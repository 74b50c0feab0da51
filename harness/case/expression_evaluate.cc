#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "case/expression.h"
#include "case/expression_node.h"

namespace etalon {
namespace {

using Node = Expression::Node;
using Shape = Builtin::Shape;

// Rows that pass through the tree at once.
constexpr std::size_t kBlock = 256;
constexpr unsigned kWidest = 16;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Rounds to binary64. The factor covers the rounding of the bounds' own arithmetic on the way.
Expression::Value Rounded(const Bounded& exact) {
    const auto value = static_cast<double>(exact.value);
    if (!std::isfinite(value)) {
        const bool certain = exact.error == 0 && !std::isfinite(exact.value);
        return {value, certain ? 0 : kInfinity};
    }
    const long double error = (exact.error + std::fabs(exact.value - value)) * (1 + 0x1p-40L);
    auto bound = static_cast<double>(error);
    if (static_cast<long double>(bound) < error) {
        bound = std::nextafter(bound, kInfinity);
    }
    return {value, bound};
}

// Components of all nodes: what one evaluation of the tree keeps at most.
std::size_t Footprint(const Node& node) {
    std::size_t components = node.components;
    for (const auto& child : node.children) {
        components += Footprint(*child);
    }
    return components;
}

// One block's values: component c of row r stands at [c * kBlock + r].
class Evaluation {
  public:
    Evaluation(const Node& root, std::span<const double* const> columns)
        : root_(root), columns_(columns), arena_(Footprint(root) * kBlock) {}

    const Bounded* Run(std::size_t first, std::size_t rows) {
        first_ = first;
        rows_ = rows;
        used_ = 0;
        return Visit(root_);
    }

  private:
    Bounded* Visit(const Node& node) {
        Bounded* const out = arena_.data() + used_;
        used_ += node.components * kBlock;
        switch (node.kind) {
            case Node::Kind::kConstant:
                std::fill_n(out, rows_, node.constant);
                break;
            case Node::Kind::kSymbol:
                for (unsigned c = 0; c < node.components; ++c) {
                    const double* const column = columns_[node.first_column + c] + first_;
                    for (std::size_t row = 0; row < rows_; ++row) {
                        out[c * kBlock + row] = {column[row], 0};
                    }
                }
                break;
            case Node::Kind::kSelect: {
                const Bounded* const from = Visit(*node.children[0]);
                for (unsigned c = 0; c < node.components; ++c) {
                    std::copy_n(from + node.selected[c] * kBlock, rows_, out + c * kBlock);
                }
                break;
            }
            case Node::Kind::kOracle:
                CallOracle(node, out);
                break;
            case Node::Kind::kBuiltin:
                CallBuiltin(node, out);
                break;
        }
        return out;
    }

    void CallBuiltin(const Node& node, Bounded* out) {
        const Bounded* arguments[4] = {};
        std::size_t strides[4] = {};
        for (std::size_t k = 0; k < node.children.size(); ++k) {
            arguments[k] = Visit(*node.children[k]);
            strides[k] = node.children[k]->components > 1 ? kBlock : 0;
        }
        const Builtin& builtin = *node.builtin;
        if (builtin.shape == Shape::kJoin) {
            Join(node, arguments, out);
            return;
        }
        if (builtin.shape == Shape::kEach) {
            for (std::size_t k = node.children.size(); k < 3; ++k) {
                arguments[k] = arguments[0];
                strides[k] = strides[0];
            }
            for (unsigned c = 0; c < node.components; ++c) {
                for (std::size_t row = 0; row < rows_; ++row) {
                    out[c * kBlock + row] = builtin.map(arguments[0][c * strides[0] + row],
                                                        arguments[1][c * strides[1] + row],
                                                        arguments[2][c * strides[2] + row]);
                }
            }
            return;
        }
        const unsigned size = node.children[0]->components;
        Bounded vectors[2][kWidest];
        Bounded result[kWidest];
        for (std::size_t row = 0; row < rows_; ++row) {
            for (std::size_t k = 0; k < node.children.size(); ++k) {
                for (unsigned c = 0; c < size; ++c) {
                    vectors[k][c] = arguments[k][c * kBlock + row];
                }
            }
            builtin.fold(vectors[0], vectors[1], size, result);
            for (unsigned c = 0; c < node.components; ++c) {
                out[c * kBlock + row] = result[c];
            }
        }
    }

    void Join(const Node& node, const Bounded* const* arguments, Bounded* out) const {
        unsigned filled = 0;
        while (filled < node.components) {
            for (std::size_t k = 0; k < node.children.size(); ++k) {
                for (unsigned c = 0; c < node.children[k]->components; ++c, ++filled) {
                    std::copy_n(arguments[k] + c * kBlock, rows_, out + filled * kBlock);
                }
            }
        }
    }

    void CallOracle(const Node& node, Bounded* out) {
        std::vector<Expression::Value> arguments;  // by columns, rows_ each
        for (const auto& child : node.children) {
            const Bounded* const values = Visit(*child);
            for (unsigned c = 0; c < child->components; ++c) {
                for (std::size_t row = 0; row < rows_; ++row) {
                    arguments.push_back(Rounded(values[c * kBlock + row]));
                }
            }
        }
        const std::size_t inputs = arguments.size() / std::max<std::size_t>(rows_, 1);
        std::vector<double> given(arguments.size());
        for (std::size_t k = 0; k < given.size(); ++k) {
            given[k] = arguments[k].value;
        }
        std::vector<double> centre(node.components * rows_);
        Call(*node.oracle, given, centre);
        const oracle::Function& function = *node.oracle;
        for (unsigned c = 0; c < node.components; ++c) {
            for (std::size_t row = 0; row < rows_; ++row) {
                const double value = centre[c * rows_ + row];
                const long double own =
                    std::isfinite(value)
                        ? (function.relative_bound * std::fabs(static_cast<long double>(value)) +
                           function.absolute_bound) /
                              (1 - static_cast<long double>(function.relative_bound))
                        : 0;
                out[c * kBlock + row] = {value, own};
            }
        }
        std::vector<double> moved(centre.size());
        for (std::size_t input = 0; input < inputs; ++input) {
            Propagate(node, arguments, given, input, centre, moved, out);
        }
    }

    // Adds what the error of one input makes of the results. The oracle is called at both ends of
    // that input's range: first order, doubled for what lies between and for joint effects. An end
    // outside the oracle's domain (no value) says nothing.
    void Propagate(const Node& node, const std::vector<Expression::Value>& arguments,
                   std::vector<double>& given, std::size_t input, const std::vector<double>& centre,
                   std::vector<double>& moved, Bounded* out) const {
        const std::size_t begin = input * rows_;
        const auto uncertain = [](const Expression::Value& value) { return value.error > 0; };
        const auto from = arguments.begin() + static_cast<std::ptrdiff_t>(begin);
        if (std::none_of(from, from + static_cast<std::ptrdiff_t>(rows_), uncertain)) {
            return;
        }
        std::vector<double> spread(centre.size(), 0.0);
        for (const double sign : {-1.0, 1.0}) {
            for (std::size_t row = 0; row < rows_; ++row) {
                const auto& [value, error] = arguments[begin + row];
                const double end = value + sign * error;
                // At least to the next double: the sum above may round back to the value.
                const double next = std::nextafter(value, sign * kInfinity);
                given[begin + row] =
                    error == 0 ? value : (sign < 0 ? std::min(end, next) : std::max(end, next));
            }
            Call(*node.oracle, given, moved);
            for (std::size_t k = 0; k < centre.size(); ++k) {
                const double apart = std::fabs(moved[k] - centre[k]);
                spread[k] = apart > spread[k] ? apart : spread[k];
            }
        }
        for (std::size_t row = 0; row < rows_; ++row) {
            given[begin + row] = arguments[begin + row].value;
            for (unsigned c = 0; c < node.components; ++c) {
                Bounded& value = out[c * kBlock + row];
                if (std::isfinite(arguments[begin + row].error)) {
                    value.error += 2 * spread[c * rows_ + row];
                } else {
                    value.error = std::numeric_limits<long double>::infinity();
                }
            }
        }
    }

    void Call(const oracle::Function& function, const std::vector<double>& given,
              std::vector<double>& results) const {
        std::vector<const double*> inputs(given.size() / rows_);
        for (std::size_t k = 0; k < inputs.size(); ++k) {
            inputs[k] = given.data() + k * rows_;
        }
        std::vector<double*> outputs(function.components);
        for (std::size_t k = 0; k < outputs.size(); ++k) {
            outputs[k] = results.data() + k * rows_;
        }
        function.evaluate(inputs.data(), outputs.data(), rows_);
    }

    const Node& root_;
    std::span<const double* const> columns_;
    std::vector<Bounded> arena_;
    std::size_t used_ = 0;
    std::size_t first_ = 0;
    std::size_t rows_ = 0;
};

bool IsExactDouble(const Node& node) {
    return node.kind == Node::Kind::kConstant && node.constant.error == 0 &&
           static_cast<long double>(static_cast<double>(node.constant.value)) ==
               node.constant.value;
}

}  // namespace

void Expression::Evaluate(std::span<const double* const> columns, std::size_t rows,
                          std::vector<Value>& results) const {
    ETALON_CHECK(root_ != nullptr && root_->components > 0);
    results.resize(root_->components * rows);
    Evaluation evaluation(*root_, columns);
    for (std::size_t first = 0; first < rows; first += kBlock) {
        const std::size_t block = std::min(kBlock, rows - first);
        const Bounded* const values = evaluation.Run(first, block);
        for (unsigned c = 0; c < root_->components; ++c) {
            for (std::size_t row = 0; row < block; ++row) {
                results[c * rows + first + row] = Rounded(values[c * kBlock + row]);
            }
        }
    }
}

bool Expression::IsFast() const {
    if (root_ == nullptr || root_->oracle == nullptr) {
        return false;
    }
    return std::all_of(root_->children.begin(), root_->children.end(), [](const auto& child) {
        return child->kind == Node::Kind::kSymbol || IsExactDouble(*child);
    });
}

void Expression::EvaluateFast(std::span<const double* const> columns, std::size_t rows,
                              std::vector<double>& results) const {
    ETALON_CHECK(IsFast());
    results.resize(root_->components * rows);
    std::vector<std::vector<double>> constants;
    constants.reserve(root_->children.size());
    std::vector<const double*> inputs;
    for (const auto& child : root_->children) {
        if (child->kind == Node::Kind::kConstant) {
            constants.emplace_back(rows, static_cast<double>(child->constant.value));
            inputs.push_back(constants.back().data());
            continue;
        }
        for (unsigned c = 0; c < child->components; ++c) {
            inputs.push_back(columns[child->first_column + c]);
        }
    }
    std::vector<double*> outputs(root_->components);
    for (std::size_t c = 0; c < outputs.size(); ++c) {
        outputs[c] = results.data() + c * rows;
    }
    root_->oracle->evaluate(inputs.data(), outputs.data(), rows);
}

double Expression::relative_bound() const {
    ETALON_CHECK(IsFast());
    return root_->oracle->relative_bound;
}

double Expression::absolute_bound() const {
    ETALON_CHECK(IsFast());
    return root_->oracle->absolute_bound;
}

}  // namespace etalon
