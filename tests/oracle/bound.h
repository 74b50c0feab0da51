// Holds an oracle against its 200-bit twin: how much of the stated bound does the worst row use?
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "big.h"
#include "oracle/function.h"

namespace etalon::oracle {

using Row = std::vector<double>;                            // flattened inputs
using Truth = std::function<std::vector<Big>(const Row&)>;  // one number per component

// Random choices that are the same everywhere.
class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    double Uniform() { return std::ldexp(static_cast<double>(bits_() >> 11), -53); }
    double Between(double low, double high) { return low + (high - low) * Uniform(); }
    // A float, as all inputs of a device are.
    double Float(double low, double high) { return static_cast<float>(Between(low, high)); }
    // Spread over the binades from 2^low to 2^high.
    double Power(double low, double high) {
        return static_cast<float>(std::exp2(Between(low, high)));
    }
    unsigned Below(unsigned count) { return static_cast<unsigned>(bits_() % count); }

  private:
    std::mt19937_64 bits_;
};

// The float `steps` floats away.
inline double Step(double value, int steps) {
    auto result = static_cast<float>(value);
    const float towards = steps < 0 ? -std::numeric_limits<float>::infinity()
                                    : std::numeric_limits<float>::infinity();
    for (int k = 0; k < std::abs(steps); ++k) {
        result = std::nextafter(result, towards);
    }
    return result;
}

struct Worst {
    double used = 0;  // |error| / bound; infinity where only one of the two is NaN, or bound is 0
    Row row;

    std::string Text() const {
        std::ostringstream text;
        text << std::setprecision(17) << "bound used " << used << " at";
        for (const double input : row) {
            text << ' ' << input;
        }
        return text.str();
    }
};

// `function` may state any bounds: what it computes is held against those. A truth of NaN is
// written as a fraction 0 / 0.
inline Worst Compare(const Function& function, const std::vector<Row>& rows, const Truth& truth) {
    std::vector<std::vector<double>> inputs(rows.front().size(), Row(rows.size()));
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t k = 0; k < inputs.size(); ++k) {
            inputs[k][row] = rows[row][k];
        }
    }
    std::vector<std::vector<double>> results(function.components, Row(rows.size()));
    std::vector<const double*> in;
    std::vector<double*> out;
    std::ranges::transform(inputs, std::back_inserter(in),
                           [](auto& column) { return column.data(); });
    std::ranges::transform(results, std::back_inserter(out),
                           [](auto& column) { return column.data(); });
    function.evaluate(in.data(), out.data(), rows.size());

    Worst worst;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::vector<Big> exact = truth(rows[row]);
        for (std::size_t k = 0; k < exact.size(); ++k) {
            const double want = exact[k].ToDouble();
            double used = std::numeric_limits<double>::infinity();
            if (std::isnan(want) || std::isnan(results[k][row])) {
                used = std::isnan(want) && std::isnan(results[k][row]) ? 0 : used;
            } else {
                const double error = Abs(Big(results[k][row]) - exact[k]).ToDouble();
                const double bound =
                    function.relative_bound * std::abs(want) + function.absolute_bound;
                used = error == 0 ? 0 : error / bound;
            }
            if (used > worst.used) {
                worst = {used, rows[row]};
            }
        }
    }
    return worst;
}

// The oracle keeps its bound, and a bound 64 times tighter would not have held: the bound says
// something, and the comparison can fail.
inline void ExpectBound(std::string_view name, const std::vector<Row>& rows, const Truth& truth) {
    const Function* function = FindFunction(name);
    ASSERT_NE(function, nullptr) << name;
    const Worst worst = Compare(*function, rows, truth);
    EXPECT_LE(worst.used, 1) << name << ": " << worst.Text();
    if (function->relative_bound != 0 || function->absolute_bound != 0) {
        EXPECT_GT(worst.used, 1.0 / 64) << name << ": the bound is needlessly wide";
    }
}

}  // namespace etalon::oracle
