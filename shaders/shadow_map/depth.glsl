// Depths in a light's map, kept as they are: linear, in float.
#ifndef ETALON_SHADOW_MAP_DEPTH
#define ETALON_SHADOW_MAP_DEPTH

#include "light_space.glsl"

// The depth of a point in light space as the map keeps it, 0 at near_plane and 1 at far_plane, for
// a 32-bit float target: -z over the range of depths. Beyond the planes it is limited to 0..1; NaN
// counts as 0. A far plane that is not beyond the near one counts as 2^-40 beyond it.
// Error: 1e-7 absolute for planes of 1e-3 to 1e3.
float light_depth(float z_light, float near_plane, float far_plane)
{
    float from = optics_limit(optics_number(near_plane), 1e18);
    float range = optics_limit(optics_number(far_plane), 1e18) - from;
    float way = optics_limit(optics_number(-z_light), 1e18) - from;
    return light_limit(way / max(range, 9.094947e-13), 0.0, 1.0);
}

// The way along the light's axis that a kept depth stands for; inverse of the above, within 2e-7 of
// the far plane.
float light_depth_way(float depth, float near_plane, float far_plane)
{
    float from = optics_limit(optics_number(near_plane), 1e18);
    float range = max(optics_limit(optics_number(far_plane), 1e18) - from, 9.094947e-13);
    return from + light_limit(depth, 0.0, 1.0) * range;
}

// What is left of the map's alpha: 1 wherever the light sees a surface, whatever its position.
// Where it sees none, the clear colour is 0.
float coverage_mask(float x)
{
    return 1.0;
}

#endif
