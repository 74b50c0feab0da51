// Faulty drivers: a probe's module with one mistake in it, of the kinds that compilers make. The
// faulty module plays the driver; the right one says what the driver should have returned.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace etalon {

struct Fault {
    enum class Kind : std::uint8_t {
        kOperandsSwapped,   // of what is not commutative: differences, comparisons, selects, pow...
        kConstantOff,       // eight ulp away from zero
        kNegationDropped,   // -x becomes x, x - y becomes x + y
        kFused,             // a product and a sum that must not be contracted, in one operation
        kIterationDropped,  // i < n becomes i + 1 < n
    };
    Kind kind = Kind::kOperandsSwapped;
    std::string what;  // "operands swapped at SPIR-V word 312 (OpFSub)"
    std::vector<std::uint32_t> spirv;
};

std::string_view NameOf(Fault::Kind kind);
inline constexpr Fault::Kind kFaultKinds[] = {
    Fault::Kind::kOperandsSwapped, Fault::Kind::kConstantOff, Fault::Kind::kNegationDropped,
    Fault::Kind::kFused, Fault::Kind::kIterationDropped};

// One for each kind and place that the module has, in the order of the places. Whether a fault
// changes any result is another matter. `spirv` is a module that spirv::ReadModule takes.
std::vector<Fault> FaultsOf(std::span<const std::uint32_t> spirv);

}  // namespace etalon
