// Profile: how far a specification lets each floating-point operation of a shader be off.
//
// Where a specification states no bound, the profile has none, and what depends on the operation is
// unbounded.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace etalon::evaluate {

struct Profile {
    std::string_view name;    // as cases write it: "vulkan-1.3"
    std::string_view source;  // the text that states the bounds
    double division_ulp = 2.5;
    bool bounds_division_by_zero = false;  // x / 0 is the infinity of mathematics' limit
    double inverse_sqrt_ulp = 2.0;
    double log_ulp = 3.0;
    double log_absolute = 0x1p-21;  // for arguments in [0.5, 2]
    double exp_ulp = 3.0;           // and exp_ulp_slope |x|
    double exp_ulp_slope = 2.0;
    // Sine, cosine, tangent, their inverses and the hyperbolic functions.
    bool bounds_trigonometry = true;
    double sine_absolute = 0x1p-11;  // for arguments in [-pi, pi]; beyond there is no bound
    double arc_tangent_ulp = 4096.0;
};

// Null for a name that is none.
const Profile* FindProfile(std::string_view name);

// "vulkan-1.3", ..., in the order of their names.
std::vector<std::string_view> ProfileNames();

}  // namespace etalon::evaluate
