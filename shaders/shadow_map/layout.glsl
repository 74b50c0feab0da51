// The map's layout: what one pass writes into its two float targets.
#ifndef ETALON_SHADOW_MAP_LAYOUT
#define ETALON_SHADOW_MAP_LAYOUT

#include "depth.glsl"
#include "irradiance.glsl"
#include "normal.glsl"

struct LightTexel {
    vec4 irradiance_depth;  // the irradiance that enters, and the linear depth 0..1
    vec4 normal_coverage;   // the normal coded to 0..1, and 1
};

// A fragment of the pass: its position and normal in light space, where the light is at
// light_position. Both targets are premultiplied by their coverage: clear them to 0 but for the
// depth, which is 1 where nothing is.
// Source: blog part one, listings 1 to 3 and the remark on multiple render targets.
LightTexel light_texel(vec3 position, vec3 normal, vec3 light_position, float near_plane,
                       float far_plane, float refr_index, vec3 intensity, vec3 albedo)
{
    vec3 to_light = light_direction(position, light_position);
    LightTexel texel;
    texel.irradiance_depth =
        vec4(light_irradiance(normal, to_light, refr_index, intensity, albedo),
             light_depth(position.z, near_plane, far_plane));
    texel.normal_coverage = vec4(normal_code(normal), coverage_mask(position.x));
    return texel;
}

#endif
