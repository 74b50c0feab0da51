#include "translucent/ray_tree.glsl"

// Reflected, transmitted, absorbed and cut shares.
vec4 shares_of(vec4 n, vec2 thickness, vec2 half_distance, float cos_i, float least)
{
    RayTree tree = trace_layers(n, thickness, half_distance, cos_i, least);
    return vec4(tree.reflected, tree.transmitted, tree.absorbed, tree.cut);
}

vec4 shares_of(vec4 n, vec2 thickness, float cos_i, float least)
{
    return shares_of(n, thickness, vec2(0.25), cos_i, least);
}
