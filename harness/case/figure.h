// Figure: the number by which a known failure is told from any other.
#pragma once

#include <cstdint>
#include <string>

namespace etalon {

struct Figure {
    enum class Measure : std::uint8_t {
        kAbsolute,  // the worst value's error
        kRelative,  // the same as a share of what was expected
        kUlp,       // the same in ulp
        kValue,     // the worst value itself
        kRefused,   // the share of the values that were refused
    };
    Measure measure = Measure::kAbsolute;
    double value = 0;
    double within = 0.01;  // of the figure's magnitude

    std::string Text() const;  // "absolute 2.57115 within 0.01"

    // NaN agrees with NaN, an infinity with itself.
    bool Agrees(double seen) const;
};

// The words of the measures, in their order.
inline constexpr const char* kMeasureNames[] = {"absolute", "relative", "ulp", "value", "refused"};

}  // namespace etalon
