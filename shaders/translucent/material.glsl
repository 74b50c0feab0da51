// A translucent layer over a solid one: what light needs to know of them, and the solid's colour in
// the light that reaches it.
//
// Positions are vec3(texture coordinates, z) and lengths box heights, as in relief/ray.glsl.
// Directions are of any length, in tangent space: x and y along the texture, z out of the surface.
// What passes for light is radiance over the square of the index that it is in, in units of the
// outer medium's: n1^2 / n^2 of the radiance. Such a value does not change on a ray but by what is
// reflected or absorbed, whether the ray enters the layer or leaves it. So surroundings of one
// brightness are as bright inside, and a lamp's light that the solid scatters in the layer is less
// by (n1 / n2)^2, as it spreads over all angles there. Light that comes back to the solid from the
// layer's inner side counts as part of the ambient light, whatever the layer absorbs.
//
// No input and no scene yields NaN or infinity: a normal or direction that is none counts as
// (0, 0, 1), colours of the solid count as 0 .. 1, amounts of light as 0 .. 65536 and what is seen
// of the surroundings as 0 .. 2^40, a NaN as the bound on the side of its sign bit.
#ifndef ETALON_TRANSLUCENT_MATERIAL
#define ETALON_TRANSLUCENT_MATERIAL

#include "../layered/unit.glsl"
#include "../optics/attenuation.glsl"
#include "../optics/limit.glsl"
#include "../optics/snell.glsl"
#include "../relief/ray.glsl"

vec3 solid_normal(vec2 uv);        // out of the solid, of about unit length
vec3 translucent_normal(vec2 uv);  // out of the layer
vec3 solid_color(vec2 uv);         // the share of the light that the solid scatters, per channel
vec3 environment(vec3 direction);  // the surroundings, in the space that `frame` leads to

// What a mirrored ray meets.
const int TRANSLUCENT_MIRROR_FAR = 0;     // the surroundings only
const int TRANSLUCENT_MIRROR_PLANE = 1;   // the solid layer, taken for a plane
const int TRANSLUCENT_MIRROR_SEARCH = 2;  // the solid layer, searched

// How the lamp's rays pass the layer.
const int TRANSLUCENT_LIGHT_STRAIGHT = 0;
const int TRANSLUCENT_LIGHT_REFRACTED = 1;

struct TranslucentSurface {
    float n1;                  // the index around
    float n2;                  // the layer's
    vec3 absorb_color;         // how strongly each channel is absorbed, 0 .. 1
    float half_distance;       // the way that halves the light then
    float texture_per_height;  // texture coordinates along a box height
    vec4 extent;               // the least and the greatest texture coordinates that there are
    vec4 lamp;                 // w = 0: the direction to it; else xyz is its position
    vec3 attenuation;          // constant, linear and quadratic factor; only with a position
    vec3 global_ambient;       // the light from everywhere
    vec3 ambient;              // the lamp's share of it, which fades with its distance
    vec3 diffuse;              // the lamp's light on a surface that faces it
    vec3 specular;             // and in the mirror
    float gloss;               // the exponent of its highlight
    float strength;            // how much brighter than `specular` the highlight is
    int light_way;             // TRANSLUCENT_LIGHT_...
    int mirror;                // TRANSLUCENT_MIRROR_...
    float plane;               // the z of that plane
    mat3 frame;                // from tangent space to the surroundings'
    ivec2 view_search;         // linear steps and bisections: of the eye's ray,
    ivec2 refraction_search;   // of refracted and mirrored rays,
    ivec2 light_search;        // and of the lamp's
};

vec3 translucent_direction(vec3 v)
{
    return layered_unit(v, vec3(0.0, 0.0, 1.0));
}

vec3 translucent_light(vec3 amount)
{
    return optics_limit(amount, 0.0, 65536.0);
}

// The unit direction from a point to the lamp.
vec3 translucent_to_lamp(vec3 point, TranslucentSurface surface)
{
    if (surface.lamp.w == 0.0) {
        return translucent_direction(surface.lamp.xyz);
    }
    float scale = relief_texture_per_height(surface.texture_per_height);
    vec3 way = optics_limit(surface.lamp.xyz, 65536.0) - point;
    return translucent_direction(vec3(way.xy / scale, way.z));
}

// What the distance to the lamp leaves of its light; 1 for a lamp without a position.
float translucent_fade(vec3 point, TranslucentSurface surface)
{
    if (surface.lamp.w == 0.0) {
        return 1.0;
    }
    float scale = relief_texture_per_height(surface.texture_per_height);
    vec3 way = optics_limit(surface.lamp.xyz, 65536.0) - point;
    way.xy /= scale;
    float longest = max(abs(way.x), max(abs(way.y), abs(way.z)));
    float distance_to_lamp = longest > 0.0 ? longest * length(way / longest) : 0.0;
    return light_attenuation(distance_to_lamp, surface.attenuation.x, surface.attenuation.y,
                             surface.attenuation.z);
}

// The surroundings in a direction of tangent space.
vec3 translucent_environment(vec3 direction, TranslucentSurface surface)
{
    mat3 frame = mat3(optics_limit(surface.frame[0], 1e6), optics_limit(surface.frame[1], 1e6),
                      optics_limit(surface.frame[2], 1e6));
    return optics_limit(environment(translucent_direction(frame * direction)), 0.0,
                        1099511627776.0);
}

// Whether texture coordinates are on the surface.
bool translucent_on_surface(vec2 uv, TranslucentSurface surface)
{
    return uv.x >= surface.extent.x && uv.y >= surface.extent.y && uv.x <= surface.extent.z &&
           uv.y <= surface.extent.w;
}

#endif
