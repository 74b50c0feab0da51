#include "evaluate/rearranged.h"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <utility>

#include "numeric/ulp.h"

namespace etalon {

std::size_t Expression::Make(int depth) {
    const auto below = [&](std::uint32_t count) {
        return static_cast<std::uint32_t>(random_() % count);
    };
    Node node;
    const std::uint32_t kind = depth == 0 ? below(5) : below(24);
    if (kind == 0) {
        node.kind = Kind::kConstant;
        node.value = static_cast<float>(below(64)) / 8.0f - 3.5f;
    } else if (depth == 0 || kind < 3) {
        node.x = below(kInputs);
    } else {
        static constexpr Kind kKinds[] = {
            Kind::kSum,        Kind::kSum,     Kind::kSum,     Kind::kSum,         Kind::kSum,
            Kind::kDifference, Kind::kProduct, Kind::kProduct, Kind::kProduct,     Kind::kProduct,
            Kind::kProduct,    Kind::kSum,     Kind::kProduct, Kind::kDifference,  Kind::kNegative,
            Kind::kQuotient,   Kind::kRoot,    Kind::kLeast,   Kind::kExponential, Kind::kChoice,
            Kind::kDifference};
        node.kind = kKinds[kind - 3];
        node.x = Make(depth - 1);
        // Some operands come twice: what may be factored out, and what cancels.
        node.y = below(5) == 0 ? Copy(node.x) : Make(depth - 1);
        node.z = node.kind == Kind::kChoice ? Make(depth - 1) : node.x;
    }
    node.origin = nodes_.size();
    return Add(node);
}

std::size_t Expression::Add(Node node) {
    nodes_.push_back(node);
    return nodes_.size() - 1;
}

std::size_t Expression::Copy(std::size_t at) {
    Node node = nodes_[at];
    if (node.kind != Kind::kInput && node.kind != Kind::kConstant) {
        node.x = Copy(node.x);
        node.y = Copy(node.y);
        node.z = Copy(node.z);
    }
    return Add(node);
}

std::string Expression::Functions() {
    return "float kept(float x) { return x; }\n"
           "float choose(float x, float y, float z) { return x < y ? z : x; }\n";
}

std::string Expression::Text(std::size_t at) const {
    const Node& node = nodes_[at];
    switch (node.kind) {
        case Kind::kInput:
            return std::string(1, static_cast<char>('a' + node.x));
        case Kind::kConstant:
            // A call: what is constant would be folded.
            return "kept(" + std::to_string(node.value) + ")";
        case Kind::kNegative:
            return "(-" + Text(node.x) + ")";
        case Kind::kSum:
            return "(" + Text(node.x) + " + " + Text(node.y) + ")";
        case Kind::kDifference:
            return "(" + Text(node.x) + " - " + Text(node.y) + ")";
        case Kind::kProduct:
            return "(" + Text(node.x) + " * " + Text(node.y) + ")";
        case Kind::kQuotient:
            return "(" + Text(node.x) + " / " + Text(node.y) + ")";
        case Kind::kRoot:
            return "sqrt(abs(" + Text(node.x) + "))";
        case Kind::kExponential:
            return "exp(min(abs(" + Text(node.x) + "), 8.0) - 4.0)";
        case Kind::kLeast:
            return "min(" + Text(node.x) + ", " + Text(node.y) + ")";
        case Kind::kChoice:
            return "choose(" + Text(node.x) + ", " + Text(node.y) + ", " + Text(node.z) + ")";
    }
    return "";
}

bool Implementation::Chance(double probability) {
    return std::uniform_real_distribution<double>(0, 1)(random_) < probability;
}

std::size_t Implementation::Below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
}

float Implementation::Flushed(float x) {
    return Chance(0.5) ? Flush(x) : x;
}

float Implementation::Within(double x, double error) {
    const double at = x + std::uniform_real_distribution<double>(-1, 1)(random_) * error;
    auto value = static_cast<float>(at);
    // Rounding must not lead out again.
    if (std::abs(static_cast<double>(value) - x) > error) {
        value = std::nextafter(value, static_cast<float>(x));
    }
    // As profile.h reads the specification.
    if (static_cast<double>(value) * x < 0) {
        value = 0;
    }
    return Flushed(value);
}

template <typename F>
float Implementation::Rounded(F f) {
    const int mode = Chance(0.5) ? FE_UPWARD : FE_DOWNWARD;
    std::fesetround(mode);
    const float result = f();
    std::fesetround(FE_TONEAREST);
    return Flushed(result);
}

float Implementation::Opaque(const Expression::Node& node) {
    using Kind = Expression::Kind;
    switch (node.kind) {
        case Kind::kRoot: {
            const double x = static_cast<double>(std::abs(Value(node.x)));
            if (!(x > 0) || x > static_cast<double>(std::numeric_limits<float>::max())) {
                return static_cast<float>(x);
            }
            const double inverse = 1 / std::sqrt(x);
            const double taken = static_cast<double>(Within(inverse, 2 * Ulp(inverse)));
            return Within(1 / taken, 2.5 * Ulp(1 / taken));
        }
        case Kind::kExponential: {
            const float x = std::min(std::abs(Value(node.x)), 8.0f);
            const double y = static_cast<double>(Rounded([&] { return x - 4.0f; }));
            const double value = std::exp(y);
            return Within(value, (3 + 2 * std::abs(y)) * Ulp(value));
        }
        case Kind::kLeast:
            return std::min(Value(node.x), Value(node.y));
        default: {
            const float x = Value(node.x);
            return x < Value(node.y) ? Value(node.z) : x;
        }
    }
}

float Implementation::Value(std::size_t at) {
    using Kind = Expression::Kind;
    const Expression::Node& node = expression_.At(at);
    switch (node.kind) {
        case Kind::kInput:
            return Flushed(inputs_[node.x]);
        case Kind::kConstant:
            return node.value;
        case Kind::kRoot:
        case Kind::kExponential:
        case Kind::kLeast:
        case Kind::kChoice: {
            const std::size_t key = finds_common_ ? node.origin : at;
            const auto found = opaque_.find(key);
            return found != opaque_.end() ? found->second : opaque_[key] = Opaque(node);
        }
        default: {
            if (!may_rearrange_) {
                return InOrder(node);
            }
            std::vector<Term> terms;
            CollectTerms(at, false, terms);
            return SumOf(std::move(terms));
        }
    }
}

float Implementation::InOrder(const Expression::Node& node) {
    using Kind = Expression::Kind;
    const float x = Value(node.x);
    if (node.kind == Kind::kNegative) {
        return -x;
    }
    const float y = Value(node.y);
    switch (node.kind) {
        case Kind::kSum:
            return Rounded([&] { return x + y; });
        case Kind::kDifference:
            return Rounded([&] { return x - y; });
        case Kind::kProduct:
            return Rounded([&] { return x * y; });
        default: {
            const double quotient = static_cast<double>(x) / static_cast<double>(y);
            return std::isfinite(quotient) && quotient != 0 ? Within(quotient, 2.5 * Ulp(quotient))
                                                            : static_cast<float>(quotient);
        }
    }
}

float Implementation::Divisor(std::size_t at) {
    const std::size_t key = finds_common_ ? expression_.At(at).origin : at;
    const auto found = opaque_.find(key);
    return found != opaque_.end() ? found->second : opaque_[key] = Value(at);
}

void Implementation::CollectTerms(std::size_t at, bool is_negative, std::vector<Term>& terms) {
    using Kind = Expression::Kind;
    const Expression::Node& node = expression_.At(at);
    const bool is_sum = node.kind == Kind::kSum || node.kind == Kind::kDifference;
    if (is_sum) {
        CollectTerms(node.x, is_negative, terms);
        CollectTerms(node.y, is_negative != (node.kind == Kind::kDifference), terms);
        return;
    }
    if (node.kind == Kind::kNegative) {
        CollectTerms(node.x, !is_negative, terms);
        return;
    }
    if (node.kind == Kind::kProduct && Chance(0.3)) {
        std::vector<Term> left;
        std::vector<Term> right;
        CollectTerms(node.x, is_negative, left);
        CollectTerms(node.y, false, right);
        if (left.size() * right.size() <= 64) {
            for (const Term& a : left) {
                for (const Term& b : right) {
                    Term both{a.is_negative != b.is_negative, a.factors};
                    both.factors.insert(both.factors.end(), b.factors.begin(), b.factors.end());
                    terms.push_back(std::move(both));
                }
            }
            return;
        }
    }
    if (node.kind == Kind::kQuotient && Chance(0.3)) {
        std::vector<Term> left;
        CollectTerms(node.x, is_negative, left);
        for (Term& term : left) {
            term.factors.push_back({node.y, true});
            terms.push_back(std::move(term));
        }
        return;
    }
    Term term{is_negative, {}};
    if (node.kind == Kind::kProduct || node.kind == Kind::kQuotient) {
        CollectFactors(at, term);
    } else {
        term.factors.push_back({at, false});
    }
    terms.push_back(std::move(term));
}

void Implementation::CollectFactors(std::size_t at, Term& term) {
    using Kind = Expression::Kind;
    const Expression::Node& node = expression_.At(at);
    if (node.kind == Kind::kProduct) {
        CollectFactors(node.x, term);
        CollectFactors(node.y, term);
    } else if (node.kind == Kind::kQuotient) {
        CollectFactors(node.x, term);
        term.factors.push_back({node.y, true});
    } else if (node.kind == Kind::kNegative) {
        term.is_negative = !term.is_negative;
        CollectFactors(node.x, term);
    } else {
        term.factors.push_back({at, false});
    }
}

float Implementation::ProductOf(const Term& term) {
    std::vector<Factor> factors = term.factors;
    std::shuffle(factors.begin(), factors.end(), random_);
    // A quotient needs something to divide.
    std::stable_partition(factors.begin(), factors.end(), [&](const Factor& factor) {
        return !factor.divides || factors.size() == 1;
    });
    if (Chance(0.5) && factors.size() > 1) {
        // Divide somewhere along the way instead of at the end.
        std::shuffle(factors.begin() + 1, factors.end(), random_);
    }
    float value = factors[0].divides ? 1.0f : Value(factors[0].node);
    for (std::size_t i = factors[0].divides ? 0 : 1; i < factors.size(); ++i) {
        const float other = factors[i].divides ? Divisor(factors[i].node) : Value(factors[i].node);
        if (!factors[i].divides) {
            value = Rounded([&] { return value * other; });
        } else if (value != 0 || other == 0) {
            const double quotient = static_cast<double>(value) / static_cast<double>(other);
            value = std::isfinite(quotient) ? Within(quotient, 2.5 * Ulp(quotient))
                                            : static_cast<float>(quotient);
        }
    }
    return term.is_negative ? -value : value;
}

bool Implementation::FactorOut(Term& a, Term& b, float& value) {
    for (std::size_t i = 0; i < a.factors.size(); ++i) {
        for (std::size_t j = 0; j < b.factors.size(); ++j) {
            const bool is_common = expression_.At(a.factors[i].node).origin ==
                                       expression_.At(b.factors[j].node).origin &&
                                   (finds_common_ || a.factors[i].node == b.factors[j].node) &&
                                   !a.factors[i].divides && !b.factors[j].divides;
            if (!is_common || a.factors.size() < 2 || b.factors.size() < 2) {
                continue;
            }
            const float common = Value(a.factors[i].node);
            a.factors.erase(a.factors.begin() + static_cast<std::ptrdiff_t>(i));
            b.factors.erase(b.factors.begin() + static_cast<std::ptrdiff_t>(j));
            const float left = ProductOf(a);
            const float right = ProductOf(b);
            const float sum = Rounded([&] { return left + right; });
            value = Rounded([&] { return common * sum; });
            return true;
        }
    }
    return false;
}

float Implementation::SumOf(std::vector<Term> terms) {
    std::vector<float> values;
    std::shuffle(terms.begin(), terms.end(), random_);
    while (!terms.empty()) {
        Term term = std::move(terms.back());
        terms.pop_back();
        float value = 0;
        if (!terms.empty() && Chance(0.3)) {
            Term other = terms.back();
            if (FactorOut(term, other, value)) {
                terms.pop_back();
                values.push_back(value);
                continue;
            }
        }
        // A product of two, contracted with what is there.
        if (!values.empty() && term.factors.size() == 2 && !term.factors[0].divides &&
            !term.factors[1].divides && Chance(0.4)) {
            const float x = Value(term.factors[0].node) * (term.is_negative ? -1.0f : 1.0f);
            const float y = Value(term.factors[1].node);
            float& sum = values[Below(values.size())];
            // The product is exact; rounding twice the same way is rounding once.
            sum = Rounded([&] {
                return static_cast<float>(static_cast<double>(x) * static_cast<double>(y) +
                                          static_cast<double>(sum));
            });
            continue;
        }
        values.push_back(ProductOf(term));
    }
    while (values.size() > 1) {
        std::swap(values[Below(values.size())], values.back());
        const float last = values.back();
        values.pop_back();
        float& sum = values[Below(values.size())];
        sum = Rounded([&] { return sum + last; });
    }
    return values[0];
}

}  // namespace etalon
