// Translucent shadow maps as the blog "Make it translucid!" has them: its mathematics and its
// flaws, with its globals as parameters. The hardened ones are in shaders/shadow_map.
#ifndef ETALON_PUBLISHED_SHADOW_MAP
#define ETALON_PUBLISHED_SHADOW_MAP

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// The maps, of which `level` is a level of detail: irradiance, and depth 0..1.
vec3 map_irradiance(vec2 uv, float level);
float map_depth(vec2 uv, float level);

// gl_Position of the vertex stage: divided by w, so that nothing is clipped by w and the varyings
// become affine. No model matrix. Part one, listings 1 and 2.
vec4 light_clip(mat4 projection, mat4 world_to_light, vec4 vertex)
{
    vec4 position = projection * world_to_light * vertex;
    position /= position.wwww;
    return position;
}

// The colour of the depth pass from the divided position, for an 8-bit target. Part one, listing 1.
float depth_code(float z_ndc)
{
    return z_ndc * 0.5 + 0.5;
}

// The alpha of the depth pass (of a position's x) and of the irradiance pass (of a normal's x), the
// dash of the listing read as a minus. Part one, listings 1 and 2.
float coverage_mask(float x)
{
    return -sign(abs(x));
}

// The same without the dash.
float coverage_mask_unsigned(float x)
{
    return sign(abs(x));
}

vec4 depth_pass(vec4 position_ls)
{
    return vec4(vec3(depth_code(position_ls.z)), coverage_mask(position_ls.x));
}

// The "light direction" of listing 2, and so the view's: it points away from the light.
vec3 light_direction(vec3 position_ls, vec3 light_position)
{
    return normalize(position_ls - light_position);
}

// Ft of listing 2. At a grazing angle it is refr_index.
float light_transmission(float refr_index, float n_dot_v)
{
    float k = pow(1.0 - max(0.0, n_dot_v), 5.0);
    return 1.0 - k + refr_index * k;
}

// E of listing 2, from a direction as light_direction gives it.
vec3 light_irradiance(vec3 normal, vec3 direction, float refr_index, vec3 intensity, vec3 albedo)
{
    float n_dot_l = dot(normal, direction);
    return vec3(light_transmission(refr_index, n_dot_l) * max(0.0, n_dot_l)) * intensity * albedo;
}

// The normal in light space, by the plain matrix. Part one, listings 2 and 3.
vec3 light_normal(mat4 world_to_light, vec3 normal)
{
    return (world_to_light * vec4(normal, 0.0)).xyz;
}

// The colour of the normal pass; not normalised. Part one, listing 3.
vec3 normal_code(vec3 normal_ls)
{
    return normal_ls * 0.5 + 0.5;
}

// The two targets of one pass that the text before listing 1 names.
struct LightTexel {
    vec4 irradiance_depth;
    vec4 normal_coverage;
};

LightTexel light_texel(vec4 position_ls, vec3 normal_ls, vec3 light_position, float refr_index,
                       vec3 intensity, vec3 albedo)
{
    vec3 n = normalize(normal_ls);
    vec3 direction = light_direction(position_ls.xyz, light_position);
    LightTexel texel;
    texel.irradiance_depth = vec4(light_irradiance(n, direction, refr_index, intensity, albedo),
                                  depth_code(position_ls.z));
    texel.normal_coverage = vec4(normal_code(n), 1.0);
    return texel;
}

// The medium of part two, one channel: albedo', z_r, z_v, and the effective extinction.
struct DipoleChannel {
    float albedo;
    float real_depth;
    float virtual_depth;
    float extinction;
};

// Part two: the light that enters at map coordinate uv and leaves at x_out (map coordinate, depth).
// The distance is the way in map coordinates and depth codes; there is no area element.
vec3 multiple_scattering(vec2 uv, vec3 x_out, float level, DipoleChannel medium)
{
    vec3 way = vec3(uv, map_depth(uv, level)) - x_out;
    float square = dot(way, way);
    float d_r = sqrt(square + medium.real_depth * medium.real_depth);
    float d_v = sqrt(square + medium.virtual_depth * medium.virtual_depth);
    float real_part = medium.real_depth * (1.0 + medium.extinction * d_r)
        * exp(-medium.extinction * d_r) / (d_r * d_r * d_r);
    float virtual_part = medium.virtual_depth * (1.0 + medium.extinction * d_v)
        * exp(-medium.extinction * d_v) / (d_v * d_v * d_v);
    return map_irradiance(uv, level)
        * (medium.albedo / (4.0 * 3.14159265) * (real_part + virtual_part));
}

// Part three: 21 taps about x_out at steps of one texel, levels 1, 2 and 3 times `smoothness`,
// weights 1/18 for the inner nine and 1/24 for the outer twelve, which sum to one: a blur in place
// of an integral. The inner nine are the centre and two to each side along the axes; where the
// outer twelve lie is not known to us, here they are the next to each side and the diagonals.
vec3 filter21(vec3 x_out, float smoothness, DipoleChannel medium)
{
    const float d = 1.0 / 1024.0;
    vec3 inner = multiple_scattering(x_out.xy, x_out, smoothness, medium);
    vec3 outer = vec3(0.0);
    for (int side = 0; side < 4; ++side) {
        vec2 axis = (side & 1) == 0 ? vec2(d, 0.0) : vec2(0.0, d);
        vec2 diagonal = (side & 1) == 0 ? vec2(d, d) : vec2(-d, d);
        float turn = side < 2 ? 1.0 : -1.0;
        for (int k = 1; k <= 2; ++k) {
            float way = turn * float(k);
            inner += multiple_scattering(x_out.xy + way * axis, x_out, smoothness, medium);
            outer +=
                multiple_scattering(x_out.xy + way * diagonal, x_out, smoothness * 2.0, medium);
        }
        outer += multiple_scattering(x_out.xy + turn * 3.0 * axis, x_out, smoothness * 3.0, medium);
    }
    return inner * 0.05556 + outer * 0.04167;
}

#endif
