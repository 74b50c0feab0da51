// The sizes of the pre-blurred maps that stand for the light scattered in a medium.
#ifndef ETALON_OPTICS_SCATTERING
#define ETALON_OPTICS_SCATTERING

#include "limit.glsl"

// The width in texels of the map of a level, 2^level for level 0 (one texel) to 30; other levels
// count as the nearest of these. Exact.
// Source: thesis eq. (20), whose n must start at 0 for the sizes that its text lists.
int scattering_map_size(int level)
{
    return 1 << clamp(level, 0, 30);
}

#endif
