// Normals in a light's map.
#ifndef ETALON_SHADOW_MAP_NORMAL
#define ETALON_SHADOW_MAP_NORMAL

#include "light_space.glsl"

// A normal in light space, of unit length, from the matrix that takes positions there (world to
// light, times the model's): its inverse transpose, which is the matrix of its cofactors over the
// determinant; only the determinant's sign matters. A mirroring or skewed matrix is as good as any.
// A zero normal, a singular matrix that leaves nothing, and NaN give (0, 0, 1). Entries up to 1e9.
// Error: 2.5e-7 k absolute, k what the terms of the product with the cofactors lose to each other:
// for the columns a, b, c, (|n.x| |b| |c| + |n.y| |c| |a| + |n.z| |a| |b|) / |product|. For a
// rotation k is at most 1.8, for columns that are nearly in one plane it is large.
// Source: blog part one, listings 2 and 3, where it is the plain matrix.
vec3 light_normal(mat4 to_light, vec3 normal)
{
    vec3 a = light_finite(to_light[0]).xyz;
    vec3 b = light_finite(to_light[1]).xyz;
    vec3 c = light_finite(to_light[2]).xyz;
    vec3 bc = cross(b, c);
    vec3 n = light_unit(normal, vec3(0.0));
    vec3 turned = n.x * bc + n.y * cross(c, a) + n.z * cross(a, b);
    return light_unit(dot(a, bc) < 0.0 ? -turned : turned, vec3(0.0, 0.0, 1.0));
}

// The texel of a normal, 0..1, for a UNORM target; a float target takes the normal itself.
vec3 normal_code(vec3 normal_light)
{
    return light_unit(normal_light, vec3(0.0, 0.0, 1.0)) * 0.5 + 0.5;
}

// The unit normal of a texel. A neutral texel of 8 bits, (128, 128, 255) / 255, is tilted by 0.32
// degrees; (0.5, 0.5, 0.5) is no normal and gives (0, 0, 1).
vec3 normal_decode(vec3 code)
{
    return light_unit(2.0 * light_limit(code, 0.0, 1.0) - 1.0, vec3(0.0, 0.0, 1.0));
}

#endif
