// What the oracles' loops share: the compiler's help and arithmetic on unevaluated sums.
#pragma once

#include <cmath>

// A loop compiled twice: where the processor has a fused multiply-add, std::fma is one instruction
// instead of a call. Sanitizers cannot run the resolver that picks one.
#if defined(__SANITIZE_ADDRESS__) || !defined(__x86_64__) || !defined(__linux__)
#define ETALON_BATCH
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ETALON_BATCH
#else
#define ETALON_BATCH __attribute__((target_clones("default", "fma")))
#endif
#else
#define ETALON_BATCH __attribute__((target_clones("default", "fma")))
#endif
// A step of such a loop; inlined, so that it is compiled for the loop's processor.
#define ETALON_STEP [[gnu::always_inline]] inline

namespace etalon::oracle {

// high + low, about 106 bits.
struct Pair {
    double high;
    double low;
};

ETALON_STEP Pair ExactSum(double a, double b) {
    const double sum = a + b;
    const double of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
}

ETALON_STEP Pair ExactProduct(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

ETALON_STEP Pair Add(Pair a, Pair b) {
    const Pair sum = ExactSum(a.high, b.high);
    return ExactSum(sum.high, sum.low + (a.low + b.low));
}

ETALON_STEP Pair Multiply(Pair a, Pair b) {
    const Pair product = ExactProduct(a.high, b.high);
    return ExactSum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

// The scalar product of component k = 0..2 of a and b, given as columns, in one row.
ETALON_STEP Pair Dot(const double* const* a, const double* const* b, std::size_t row) {
    return Add(Add(ExactProduct(a[0][row], b[0][row]), ExactProduct(a[1][row], b[1][row])),
               ExactProduct(a[2][row], b[2][row]));
}

}  // namespace etalon::oracle
