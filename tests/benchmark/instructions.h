// What stands in a SPIR-V module.
#pragma once

#include <cstdint>
#include <span>

namespace etalon {

struct InstructionCount {
    std::uint64_t computing = 0;  // arithmetic, comparisons, choices, calls of built-in functions,
                                  // reads of images, phis and branches on a condition
    std::uint64_t fetches = 0;    // reads of images, among these
    bool loops = false;           // there is a loop
};

// Counts the instructions of all functions. Sums and products of integers, of which the probe's own
// addresses are made, are left out.
InstructionCount CountInstructions(std::span<const std::uint32_t> module);

}  // namespace etalon
