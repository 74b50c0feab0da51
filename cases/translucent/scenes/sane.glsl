// In integers: what a comparison with NaN says is open.
#include "relief/ray.glsl"

bool sane_number(float x, float most)
{
    return (floatBitsToUint(x) & 0x7fffffffu) <= floatBitsToUint(most);
}

// 1 for light that is a number and not negative.
float sane(vec3 light)
{
    bool numbers = sane_number(light.x, 3e38) && sane_number(light.y, 3e38) &&
                   sane_number(light.z, 3e38);
    return numbers && min(min(light.x, light.y), light.z) >= 0.0 ? 1.0 : 0.0;
}

// 1 for a share of each colour.
float sane_share(vec3 share)
{
    return sane(share) > 0.0 && max(max(share.x, share.y), share.z) <= 1.0 ? 1.0 : 0.0;
}

// 1 for texture coordinates and a way along a ray, or -1 for none.
float sane_place(vec3 place)
{
    return sane_number(place.x, 2e6) && sane_number(place.y, 2e6) &&
                   sane_number(place.z, RELIEF_MAX_WAY) && place.z >= -1.0
               ? 1.0
               : 0.0;
}
