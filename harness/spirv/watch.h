// Watching a module: makes it tell, beside its outputs, what its operations yield.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "spirv/module.h"

namespace etalon::spirv {

// The scalars of a value, in the order in which a watched module tells them: floats before ints and
// bools, each in the order of the members.
struct Leaf {
    std::vector<std::uint32_t> path;  // indices of OpCompositeExtract
    std::uint32_t type = kNone;
};
std::vector<Leaf> Leaves(const Module& module, std::uint32_t type);

// How many of a type's leaves are floats.
std::uint32_t CountFloats(const Module& module, std::uint32_t type);

// True for what computes with floats: arithmetic, GLSL.std.450, comparisons, conversions, image
// reads. False for what only moves values (loads, composites, bit casts, choices, calls).
bool IsWatchable(const Module& module, const Instruction& instruction);

// The watchable instructions, by Instruction::word, ascending. A watched module calls each by its
// place in this list.
std::vector<std::uint32_t> Watchable(const Module& module);

// Where a watched module writes, in words of its outputs (binding 1, one row). The first word tells
// how many leaves were met; then come two words for each of the first `most`: who yielded it, and
// the word itself. It is complete once the probe has stored its last output.
struct WatchPlace {
    std::uint32_t first = 0;
    std::uint32_t most = 0;

    std::uint32_t Words() const { return 1 + 2 * (most + 1); }  // the last pair is of no use
};

// Who yielded a leaf.
inline constexpr std::uint32_t kWatchLeaves = 64;  // of one instruction, at most
struct WatchMark {
    std::uint32_t instruction = 0;  // place in Watchable()
    std::uint32_t leaf = 0;
};
inline std::uint32_t PackMark(WatchMark mark) {
    return mark.instruction * kWatchLeaves + mark.leaf;
}
inline WatchMark UnpackMark(std::uint32_t word) {
    return {word / kWatchLeaves, word % kWatchLeaves};
}

// The module with the watching of those instructions (places in Watchable(), ascending) added. The
// program's own instructions stay as they are. `module` is what ReadModule made of `words`, a
// probe for one row. Fails where it has no outputs at binding 1.
Result<std::vector<std::uint32_t>> Watch(std::span<const std::uint32_t> words, const Module& module,
                                         WatchPlace place, std::span<const std::uint32_t> chosen);

}  // namespace etalon::spirv
