// Light's maps as formulas; shadow_map.sum in harness/oracle is the sum over their texels.
//   scene 0  a plate: depth 2, where x and y are within +-3
//   scene 1  a tilted plate: depth 2 + x / 2, where x and y are within +-3
//   scene 2  a sphere of radius 2 about depth 4
//   scene 3  a wedge: depth 2 + |x| / 2, where x and y are within +-3
//   scene 4  a slab without end: depth 2
// lit across the light by 1. The map is 8 wide, x and y are -4 to 4.
uniform float scene;

#ifndef DEPTH_UNIT
#define DEPTH_UNIT 1.0
#endif

vec2 place(vec2 uv)
{
    return (uv - 0.5) * 8.0;
}

float map_depth(vec2 uv, float level)
{
    vec2 p = place(uv);
    if (scene < 0.5 || scene > 3.5) {
        return 2.0 * DEPTH_UNIT;
    }
    if (scene < 1.5) {
        return (2.0 + 0.5 * p.x) * DEPTH_UNIT;
    }
    if (scene < 2.5) {
        return (4.0 - sqrt(max(4.0 - dot(p, p), 0.0))) * DEPTH_UNIT;
    }
    return (2.0 + 0.5 * abs(p.x)) * DEPTH_UNIT;
}

vec3 map_normal(vec2 uv, float level)
{
    vec2 p = place(uv);
    if (scene < 0.5 || scene > 3.5) {
        return vec3(0.0, 0.0, 1.0);
    }
    if (scene < 1.5) {
        return vec3(-0.44721360, 0.0, 0.89442719);
    }
    if (scene < 2.5) {
        return vec3(p, sqrt(max(4.0 - dot(p, p), 0.0))) * 0.5;
    }
    return vec3(p.x < 0.0 ? -0.44721360 : 0.44721360, 0.0, 0.89442719);
}

// The mean over a texel of that level, 128 to the map's side; of the sphere, its middle.
float covered(float x, float level)
{
    float texel = 0.0625 * exp2(level);
    return max(min(x + 0.5 * texel, 3.0) - max(x - 0.5 * texel, -3.0), 0.0) / texel;
}

vec3 map_irradiance(vec2 uv, float level)
{
    vec2 p = place(uv);
    if (scene > 3.5) {
        return vec3(1.0);
    }
    if (scene > 1.5 && scene < 2.5) {
        return vec3(sqrt(max(4.0 - dot(p, p), 0.0)) * 0.5);
    }
    return vec3(map_normal(uv, level).z * covered(p.x, level) * covered(p.y, level));
}
