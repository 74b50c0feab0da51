// Random expressions, and one conforming implementation after another that evaluates them.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace etalon {

// An expression over the inputs a, b, c, d.
class Expression {
  public:
    enum class Kind : std::uint8_t {
        kInput,
        kConstant,
        kNegative,
        kSum,
        kDifference,
        kProduct,
        kQuotient,
        kRoot,         // sqrt(abs(x))
        kExponential,  // exp(min(abs(x), 8) - 4)
        kLeast,
        kChoice,  // x < y ? z : x
    };
    struct Node {
        Kind kind = Kind::kInput;
        std::size_t x = 0;
        std::size_t y = 0;
        std::size_t z = 0;
        float value = 0;  // of a constant; `x` is the index of an input
        // The same for nodes that stand for the same expression, written several times.
        std::size_t origin = 0;
    };
    static constexpr std::size_t kInputs = 4;

    Expression(std::mt19937& random, int depth) : random_(random) { root_ = Make(depth); }

    std::string Text() const { return Text(root_); }
    // GLSL functions that the text calls.
    static std::string Functions();

    const Node& At(std::size_t node) const { return nodes_[node]; }
    std::size_t root() const { return root_; }

  private:
    std::size_t Make(int depth);
    std::size_t Copy(std::size_t node);
    std::size_t Add(Node node);
    std::string Text(std::size_t node) const;

    std::mt19937& random_;
    std::vector<Node> nodes_;
    std::size_t root_ = 0;
};

// Evaluates as a conforming implementation may: every operation rounded either way or wrong by what
// Vulkan allows, subnormal numbers flushed at random; and where it may rearrange, sums and products
// in any order, contracted, distributed and factored out at random.
class Implementation {
  public:
    Implementation(std::mt19937& random, const Expression& expression,
                   const std::vector<float>& inputs, bool may_rearrange)
        : random_(random),
          expression_(expression),
          inputs_(inputs),
          may_rearrange_(may_rearrange),
          finds_common_(Chance(0.5)) {}

    float Run() { return Value(expression_.root()); }

  private:
    struct Factor {
        std::size_t node = 0;
        bool divides = false;
    };
    struct Term {
        bool is_negative = false;
        std::vector<Factor> factors;
    };

    bool Chance(double probability);
    std::size_t Below(std::size_t count);
    float Flushed(float x);
    // A float in [x - error, x + error].
    float Within(double x, double error);
    template <typename F>
    float Rounded(F f);

    float Value(std::size_t node);
    float InOrder(const Expression::Node& node);
    // Of a function: the same each time that it is used.
    float Opaque(const Expression::Node& node);
    // The same for each of the terms over it.
    float Divisor(std::size_t node);
    void CollectTerms(std::size_t node, bool is_negative, std::vector<Term>& terms);
    void CollectFactors(std::size_t node, Term& term);
    float SumOf(std::vector<Term> terms);
    float ProductOf(const Term& term);
    // Takes a factor that both have out of them.
    bool FactorOut(Term& a, Term& b, float& value);

    std::mt19937& random_;
    const Expression& expression_;
    const std::vector<float>& inputs_;
    const bool may_rearrange_;
    const bool finds_common_;  // expressions that are written several times
    std::map<std::size_t, float> opaque_;
};

}  // namespace etalon
