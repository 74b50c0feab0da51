// Light space: where a point stands in a light's map.
//
// Light space has the light's axis as -z, as a camera has it; the light is at the origin, or, where
// it is parallel, far up the z axis. A clip position keeps its w: the rasteriser clips by it and
// divides varyings by it.
#ifndef ETALON_SHADOW_MAP_LIGHT_SPACE
#define ETALON_SHADOW_MAP_LIGHT_SPACE

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// x where it is a number from low to high, else the nearer bound; `low` for NaN.
float light_limit(float x, float low, float high)
{
    return x >= low ? min(x, high) : low;
}

vec3 light_limit(vec3 v, float low, float high)
{
    return vec3(light_limit(v.x, low, high), light_limit(v.y, low, high),
                light_limit(v.z, low, high));
}

// Of unit length, for vectors of any length; `instead` for zero, or where no component is a number.
vec3 light_unit(vec3 v, vec3 instead)
{
    vec3 limited = vec3(v.x >= -1e18 ? min(v.x, 1e18) : (v.x < 0.0 ? -1e18 : 0.0),
                        v.y >= -1e18 ? min(v.y, 1e18) : (v.y < 0.0 ? -1e18 : 0.0),
                        v.z >= -1e18 ? min(v.z, 1e18) : (v.z < 0.0 ? -1e18 : 0.0));
    float longest = max(abs(limited.x), max(abs(limited.y), abs(limited.z)));
    return longest >= 1e-18 ? normalize(limited / longest) : instead;
}

// The vertex stage's gl_Position, of a world position: nothing is divided. Error: 4 ulp of the
// largest term of each component. Components of the inputs up to 1e9 yield no infinity.
// Source: blog part one, listing 1, without its division.
vec4 light_clip(mat4 projection, mat4 world_to_light, vec4 position)
{
    return projection * (world_to_light * position);
}

// As above for a model's own position, 1 its w.
vec4 light_clip(mat4 projection, mat4 world_to_light, mat4 model, vec3 position)
{
    return projection * (world_to_light * (model * vec4(position, 1.0)));
}

// Map coordinates 0..1 and whether the point is on the map: (u, v, 1), or (0, 0, 0) for what lies
// outside of the light's volume, behind the light, or is no number. For the fragment stage. Exact
// but for the rounding of x / w: 1.5e-7 absolute.
vec3 light_map_coordinate(vec4 clip)
{
    bool inside = clip.w >= 1e-18 && clip.w <= 1e18 && abs(clip.x) <= clip.w
        && abs(clip.y) <= clip.w && abs(clip.z) <= clip.w;
    return inside ? vec3(clip.xy / clip.w * 0.5 + 0.5, 1.0) : vec3(0.0);
}

#endif
