// Light that scatters on its way through a medium, imitated by maps that were blurred before.
//
// Level 0 is the map itself; level k has been blurred by a Gaussian of standard deviation
// sigma_1 2^(k-1), in texture coordinates, and may be kept at size 2^(n-k) for a map of size 2^n,
// down to one texel at level n. `vec3 blurred(vec2 uv, int level)` gives their colours, which
// count as 0..65504; what is no number counts as 0.
#ifndef ETALON_TRANSLUCENT_SCATTERING
#define ETALON_TRANSLUCENT_SCATTERING

#include "../optics/limit.glsl"

vec3 blurred(vec2 uv, int level);

const int SCATTERING_MAX_LEVEL = 16;

struct ScatteringLevel {
    int level;    // the sharper of the two neighbours
    float blend;  // how much of the next one, 0..1
};

// Which levels stand for a blur of standard deviation sigma: the blend's variance is that of the
// wanted blur, sigma^2 = (1 - blend) s_k^2 + blend s_(k+1)^2 with s_0 = 0. Wider blurs than the
// last level's are that one. sigma and sigma_1 in the same unit, last level 0..16. A sigma that is
// negative or no number is 0; sigma_1 counts as at least 2^-40 and at most 2^40. Error of blend:
// 1e-6, and relative 1e-6 of the variance. Source: thesis (20) and 3.2.3.
ScatteringLevel scattering_level(float sigma, float sigma_1, int last_level)
{
    int last = clamp(last_level, 0, SCATTERING_MAX_LEVEL);
    float unit = optics_limit(optics_number(sigma_1), 9.094947017729282e-13, 1099511627776.0);
    // 2^57: no unit leaves more than the limit of that.
    float wide = optics_limit(optics_number(sigma), 0.0, 144115188075855872.0);
    float ratio = min(wide / unit, 131072.0);
    float variance = ratio * ratio;
    float lower = 0.0;
    float upper = 1.0;
    for (int level = 0; level < last; ++level) {
        if (variance < upper) {
            return ScatteringLevel(level, (variance - lower) / (upper - lower));
        }
        lower = upper;
        upper *= 4.0;
    }
    return ScatteringLevel(last, 0.0);
}

// The standard deviation after a way d through a medium in which a beam spreads by the angle
// `spread` (radians, small) over each unit of way: d * spread, both at least 0 and at most 2^20.
float scattering_sigma(float d, float spread)
{
    return optics_limit(optics_number(d), 0.0, 1048576.0) *
           optics_limit(optics_number(spread), 0.0, 1048576.0);
}

vec3 scattering_color(vec2 uv, int level)
{
    return optics_limit(optics_number(blurred(uv, level)), 0.0, 65504.0);
}

// The colour at uv blurred by sigma.
vec3 scattered(vec2 uv, float sigma, float sigma_1, int last_level)
{
    ScatteringLevel at = scattering_level(sigma, sigma_1, last_level);
    vec3 sharp = scattering_color(uv, at.level);
    return at.blend > 0.0 ? mix(sharp, scattering_color(uv, at.level + 1), at.blend) : sharp;
}

#endif
