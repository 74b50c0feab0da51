// Holds the error bounds of host expressions against MPFR at 400 bits, over random expressions.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "case/expression.h"
#include "numeric/sampling.h"

namespace etalon {
namespace {

// A value of 400 bits.
class Exact {
  public:
    Exact() { mpfr_init2(value_, 400); }
    explicit Exact(double value) : Exact() { mpfr_set_d(value_, value, MPFR_RNDN); }
    Exact(const Exact& other) : Exact() { mpfr_set(value_, other.value_, MPFR_RNDN); }
    Exact& operator=(const Exact& other) {
        mpfr_set(value_, other.value_, MPFR_RNDN);
        return *this;
    }
    ~Exact() { mpfr_clear(value_); }

    mpfr_ptr get() { return value_; }
    mpfr_srcptr get() const { return value_; }

  private:
    mpfr_t value_;
};

using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using Binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

int Inverse(mpfr_ptr out, mpfr_srcptr x, mpfr_rnd_t mode) {
    return mpfr_rec_sqrt(out, x, mode);
}

int Modulo(mpfr_ptr out, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t mode) {
    Exact quotient;
    mpfr_div(quotient.get(), x, y, mode);
    mpfr_floor(quotient.get(), quotient.get());
    mpfr_mul(quotient.get(), quotient.get(), y, mode);
    return mpfr_sub(out, x, quotient.get(), mode);
}

struct Operation {
    const char* before;
    const char* between;
    const char* after;
    Unary unary;
    Binary binary;
};

// The text around the operands, and the same in MPFR.
const Operation kOperations[] = {
    {"(", " + ", ")", nullptr, mpfr_add},
    {"(", " - ", ")", nullptr, mpfr_sub},
    {"(", " * ", ")", nullptr, mpfr_mul},
    {"(", " / ", ")", nullptr, mpfr_div},
    {"min(", ", ", ")", nullptr, mpfr_min},
    {"max(", ", ", ")", nullptr, mpfr_max},
    {"length(vec2(", ", ", "))", nullptr, mpfr_hypot},
    {"atan(", ", ", ")", nullptr, mpfr_atan2},
    {"mod(", ", ", ")", nullptr, Modulo},
    {"(abs(", ") ^ ", ")", nullptr,
     [](mpfr_ptr out, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t mode) {
         Exact positive;
         mpfr_abs(positive.get(), x, mode);
         return mpfr_pow(out, positive.get(), y, mode);
     }},
    {"sqrt(", "", ")", mpfr_sqrt, nullptr},
    {"inversesqrt(", "", ")", Inverse, nullptr},
    {"exp(", "", ")", mpfr_exp, nullptr},
    {"exp2(", "", ")", mpfr_exp2, nullptr},
    {"log(", "", ")", mpfr_log, nullptr},
    {"log2(", "", ")", mpfr_log2, nullptr},
    {"sin(", "", ")", mpfr_sin, nullptr},
    {"cos(", "", ")", mpfr_cos, nullptr},
    {"tan(", "", ")", mpfr_tan, nullptr},
    {"asin(", "", ")", mpfr_asin, nullptr},
    {"acos(", "", ")", mpfr_acos, nullptr},
    {"atan(", "", ")", mpfr_atan, nullptr},
    {"sinh(", "", ")", mpfr_sinh, nullptr},
    {"cosh(", "", ")", mpfr_cosh, nullptr},
    {"tanh(", "", ")", mpfr_tanh, nullptr},
    {"abs(", "", ")", mpfr_abs, nullptr},
    {"fract(", "", ")",
     [](mpfr_ptr out, mpfr_srcptr x, mpfr_rnd_t mode) {
         Exact whole;
         mpfr_floor(whole.get(), x);
         return mpfr_sub(out, x, whole.get(), mode);
     },
     nullptr},
    {"(", "", ")^3",
     [](mpfr_ptr out, mpfr_srcptr x, mpfr_rnd_t m) { return mpfr_pow_ui(out, x, 3, m); }, nullptr},
    {"(", "", ")^-2",
     [](mpfr_ptr out, mpfr_srcptr x, mpfr_rnd_t m) { return mpfr_pow_si(out, x, -2, m); }, nullptr},
};

class Generator {
  public:
    Generator(std::uint64_t seed, const std::vector<double>& inputs)
        : seed_(seed), inputs_(inputs) {}

    Exact Make(int depth, std::string& text) {
        const std::uint64_t pick = Mix(seed_, index_++);
        if (depth == 0 || pick % 7 == 0) {
            const std::size_t input = (pick >> 8) % (inputs_.size() + 1);
            if (input == inputs_.size()) {
                text += "0.3";
                Exact value(3);
                mpfr_div_ui(value.get(), value.get(), 10, MPFR_RNDN);
                return value;
            }
            text += std::string(1, static_cast<char>('x' + input));
            return Exact(inputs_[input]);
        }
        const Operation& operation = kOperations[(pick >> 8) % std::size(kOperations)];
        Exact result;
        text += operation.before;
        const Exact first = Make(depth - 1, text);
        if (operation.binary != nullptr) {
            text += operation.between;
            const Exact second = Make(depth - 1, text);
            operation.binary(result.get(), first.get(), second.get(), MPFR_RNDN);
        } else {
            operation.unary(result.get(), first.get(), MPFR_RNDN);
        }
        text += operation.after;
        return result;
    }

  private:
    std::uint64_t seed_;
    std::uint64_t index_ = 0;
    const std::vector<double>& inputs_;
};

TEST(ExpressionBound, CoversTheExactValue) {
    int compared = 0;
    int tight = 0;
    for (std::uint64_t trial = 0; trial < 20000; ++trial) {
        std::vector<double> inputs;
        for (std::uint64_t k = 0; k < 3; ++k) {
            inputs.push_back(static_cast<float>(std::exp2(4 * Uniform(trial, 1000 + k) - 3) *
                                                (Uniform(trial, 2000 + k) < 0.3 ? -1 : 1)));
        }
        std::string text;
        const Exact exact = Generator(trial, inputs).Make(1 + static_cast<int>(trial % 5), text);
        auto expression = Expression::Parse(text);
        ASSERT_TRUE(expression) << text << ": " << expression.error().message;
        const Symbol symbols[] = {{"x", 1}, {"y", 1}, {"z", 1}};
        ASSERT_TRUE(expression->Bind(symbols)) << text;
        const double* columns[] = {&inputs[0], &inputs[1], &inputs[2]};
        std::vector<Expression::Value> values;
        expression->Evaluate(columns, 1, values);
        const auto [value, error] = values[0];
        if (!std::isfinite(error) || !std::isfinite(value) || mpfr_number_p(exact.get()) == 0) {
            continue;
        }
        ++compared;
        Exact apart;
        mpfr_sub_d(apart.get(), exact.get(), value, MPFR_RNDN);
        mpfr_abs(apart.get(), apart.get(), MPFR_RNDN);
        EXPECT_LE(mpfr_cmp_d(apart.get(), error), 0)
            << text << " at " << inputs[0] << ", " << inputs[1] << ", " << inputs[2] << ": "
            << value << " is off by " << mpfr_get_d(apart.get(), MPFR_RNDN) << ", bound " << error;
        tight += error <= 1e-14 * std::fabs(value) ? 1 : 0;
    }
    EXPECT_GT(compared, 8000);
    EXPECT_GT(tight, compared * 9 / 10) << "a bound that covers everything would prove nothing";
}

// The check above must be able to fail: a wrong value of one part in 2^60 lies outside the bound.
TEST(ExpressionBound, IsNotVacuous) {
    auto expression = *Expression::Parse("(exp(x) - (1 + 2^-60) * exp(x)) / exp(x)");
    const Symbol symbols[] = {{"x", 1}};
    ASSERT_TRUE(expression.Bind(symbols));
    const double x = 0.75;
    const double* columns[] = {&x};
    std::vector<Expression::Value> values;
    expression.Evaluate(columns, 1, values);
    EXPECT_LE(std::fabs(values[0].value + 0x1p-60), values[0].error);
    EXPECT_LT(values[0].error, 0x1p-57);
}

}  // namespace
}  // namespace etalon
