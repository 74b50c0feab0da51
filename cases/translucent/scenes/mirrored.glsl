// How the solid's light differs where the scene is mirrored, and the lamp.
#include "translucent/light.glsl"

TranslucentSurface surface();

vec3 change_by_mirroring(vec2 uv)
{
    TranslucentSurface seen = surface();
    vec3 change = assemble_surface_sample(uv, seen);
    mirror_u = -1.0;
    seen.lamp.x = -seen.lamp.x;
    return assemble_surface_sample(vec2(-uv.x, uv.y), seen) - change;
}
