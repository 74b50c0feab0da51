// Evaluates a compute probe (probe/program.h) on the host.
//
// Number is the type of every floating-point value: float, each operation rounded correctly in the
// order of the source, with subnormal numbers; double; Big (big.h). What holds for all:
//   - integers and bools are exact and have 32 bits; bit casts see and yield binary32, to which
//     numbers are rounded;
//   - the functions of GLSL.std.450 that stand for a formula (length, mix, reflect...) are that
//     formula's operations, each rounded; elementary functions (sin, pow...) are those of the host
//     in binary64, rounded once, of Big those of MPFR;
//   - what the specification leaves undefined has one meaning: a variable without a value is 0; a
//     division of integers by 0 is 0 and its remainder is the dividend; shifts take the lowest five
//     bits; conversions to integers saturate, a NaN is 0; min, max and clamp take the number where
//     the other is a NaN, and of two zeros the first; pow, acos and the like are the host's outside
//     their domains. An index out of range is an error.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "evaluate/plan.h"

namespace etalon::evaluate {

struct Texture {
    std::shared_ptr<const Image> image;
    Sampling sampling;
};

struct Limits {
    // Iterations of loops and calls of functions, together, of one row.
    std::uint32_t steps = 1u << 22;
    // Ways through the program that the undecided comparisons of one row may lead to; of bounds.
    std::uint32_t ways = 64;
    // And those of all rows on average; beyond, rows that have more than one are unbounded.
    std::uint32_t mean_ways = 6;
};

// Words by columns, as a device takes them.
template <typename Number>
struct Rows {
    std::uint32_t count = 0;
    std::span<const std::uint32_t> inputs;
    std::span<std::uint32_t> outputs;
    // Empty, or as large as `outputs`: the outputs before they were rounded to binary32. Of an
    // output that is no float, its bits taken as one.
    std::span<Number> exact = {};
    // Empty, or as large as all functions' blocks times `count`: how often each row entered each
    // block is added here, of block b (of all functions one after the other) at row r to
    // [b * count + r].
    std::span<std::uint32_t> visits = {};
};

template <typename Number>
class Evaluator {
  public:
    // The plan and the images must outlive it; images stand in the order of their bindings.
    Evaluator(std::shared_ptr<const Plan> plan, const std::vector<Texture>& images,
              Limits limits = {});
    ~Evaluator();
    Evaluator(const Evaluator&) = delete;
    Evaluator& operator=(const Evaluator&) = delete;

    // Fails with the row, the line where the module has lines, and the function where a row goes
    // beyond the limits, a buffer or an array.
    Status<> Run(const Rows<Number>& rows);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace etalon::evaluate
