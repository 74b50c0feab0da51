// Profile: how far a specification lets each floating-point operation of a shader be off.
//
// Where a specification states no bound, the profile has none, and what depends on the operation is
// unbounded. Our reading, where the text leaves one: an error in ulp does not change a result's
// sign; of sqrt(0), inherited from a division by an infinity, the result is 0.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace etalon::evaluate {

struct Profile {
    std::string_view name;      // as cases write it: "vulkan-1.3"
    std::string_view source;    // the text that states the bounds
    double division_ulp = 2.5;  // of denominators within [2^-126, 2^126]; beyond, and by zero,
                                // there is no bound
    double inverse_sqrt_ulp = 2.0;
    double log_ulp = 3.0;
    double log_absolute = 0x1p-21;  // for arguments in [0.5, 2]
    double exp_ulp = 3.0;           // and exp_ulp_slope |x|
    double exp_ulp_slope = 2.0;
    // Of sine, cosine, tangent, their inverses and the hyperbolic functions there are bounds.
    bool bounds_trigonometry = true;
    double sine_absolute = 0x1p-11;  // for arguments in [-pi, pi]; beyond there is no bound
    double arc_tangent_ulp = 4096.0;
    // The remainder of a negative integer is that of the divisor's sign, and not left open.
    bool defines_negative_modulus = true;
    // Filtered images: how far the weights of texels and levels may be off.
    double weight_absolute = 0x1p-4;

    bool operator==(const Profile&) const = default;
};

// Null for a name that is none.
const Profile* FindProfile(std::string_view name);

// "vulkan-1.3", ..., in the order of their names.
std::vector<std::string_view> ProfileNames();

}  // namespace etalon::evaluate
