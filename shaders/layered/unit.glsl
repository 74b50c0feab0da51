// Directions of any length.
#ifndef ETALON_LAYERED_UNIT
#define ETALON_LAYERED_UNIT

#include "../optics/limit.glsl"

// v with a length of one, within 2e-7; `otherwise` where all components are below 1e-18. A NaN
// counts as 1e18 with its sign, as does all that is larger. No input yields NaN.
vec3 layered_unit(vec3 v, vec3 otherwise)
{
    v = optics_limit(v, 1e18);
    float longest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    return longest >= 1e-18 ? normalize(v / longest) : otherwise;
}

#endif
