// Light space: where a point stands in a light's map.
//
// Light space has the light's axis as -z, as a camera has it; the light is at the origin, or, where
// it is parallel, far up the z axis. A clip position keeps its w: the rasteriser clips by it and
// divides varyings by it.
#ifndef ETALON_SHADOW_MAP_LIGHT_SPACE
#define ETALON_SHADOW_MAP_LIGHT_SPACE

#include "../layered/unit.glsl"

// x where it is a number from low to high, 0 <= low, else the nearer bound; `low` for NaN.
float light_limit(float x, float low, float high)
{
    return optics_limit(optics_number(x), low, high);
}

vec3 light_limit(vec3 v, float low, float high)
{
    return optics_limit(optics_number(v), low, high);
}

// Of unit length, for vectors of any length; `instead` for zero, or where no component is a number.
vec3 light_unit(vec3 v, vec3 instead)
{
    return layered_unit(optics_number(v), instead);
}

vec4 light_finite(vec4 v)
{
    return optics_limit(optics_number(v), 1e9);
}

mat4 light_finite(mat4 m)
{
    return mat4(light_finite(m[0]), light_finite(m[1]), light_finite(m[2]), light_finite(m[3]));
}

// The vertex stage's gl_Position, of a world position: nothing is divided. Error: 4 ulp of the
// largest term of each component. Components of the inputs are limited to +-1e9, a NaN counts as 0:
// no input yields NaN or infinity.
// Costs the published form's arithmetic and those limits; those of a matrix that is a uniform need
// be taken once only.
// Source: blog part one, listing 1, without its division.
vec4 light_clip(mat4 projection, mat4 world_to_light, vec4 position)
{
    return light_finite(projection) * (light_finite(world_to_light) * light_finite(position));
}

// As above for a model's own position, 1 its w.
vec4 light_clip(mat4 projection, mat4 world_to_light, mat4 model, vec3 position)
{
    vec4 world = light_finite(model) * light_finite(vec4(position, 1.0));
    return light_finite(projection) * (light_finite(world_to_light) * world);
}

// Map coordinates 0..1 and whether the point is on the map: (u, v, 1), or (0, 0, 0) for what lies
// outside of the light's volume, behind the light, or is no number. For the fragment stage. Exact
// but for the rounding of x / w: 1.5e-7 absolute.
vec3 light_map_coordinate(vec4 clip)
{
    // NaN becomes more than w may be.
    clip = optics_limit(clip, 2e18);
    bool inside = clip.w >= 1e-18 && clip.w <= 1e18 && abs(clip.x) <= clip.w
        && abs(clip.y) <= clip.w && abs(clip.z) <= clip.w;
    return inside ? vec3(clip.xy / clip.w * 0.5 + 0.5, 1.0) : vec3(0.0);
}

#endif
