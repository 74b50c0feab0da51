// The ray of a relief, its hit, and the heights of its layers: what all searches share.
//
// A relief is a box of height one, z = -0.5 .. 0.5, over a polygon. Its unit of length is that
// height in every direction; `texture_per_height` says how many texture coordinates lie along it
// (twice the relative height of the thesis: 0.1 for 0.05). Positions are vec3(texture coordinates,
// z). A ray is at start + t * velocity after the way t, in box heights. A layer is met at the first
// t at which its height is not below the ray: heights are single-valued, a ray that starts in a
// layer meets it at t = 0, and where both layers are met at once the solid is.
//
// The scene gives the heights as z at a texture coordinate; they are clamped to the box, and a NaN
// counts as the floor.
#ifndef ETALON_RELIEF_RAY
#define ETALON_RELIEF_RAY

#include "../optics/limit.glsl"

float solid_height(vec2 uv);
float translucent_height(vec2 uv);

const int RELIEF_NONE = 0;
const int RELIEF_TRANSLUCENT = 1;
const int RELIEF_SOLID = 2;

// No search makes more steps than this, of whatever kind.
const int RELIEF_MAX_STEPS = 1024;
// Rays end after this way at the latest, in box heights: one at 89.1 degrees crosses the box in 64.
const float RELIEF_MAX_WAY = 64.0;

struct ReliefRay {
    vec3 start;
    vec3 velocity;  // the unit direction, its xy times texture_per_height
    float end;      // the way to the box's floor or top, or RELIEF_MAX_WAY
};

// Where none is met, t is -1, position the ray's end, and the bracket all of the ray.
struct ReliefHit {
    int layer;  // RELIEF_NONE, RELIEF_TRANSLUCENT or RELIEF_SOLID
    float t;
    vec3 position;
    float t_above;  // the layer is below the ray here,
    float t_below;  // and not here
};

// x where it is a number within +-limit, else the nearer bound; 0 for NaN.
float relief_finite(float x, float limit)
{
    return optics_limit(optics_number(x), limit);
}

float relief_height(float height)
{
    bool none = (floatBitsToInt(height) & 0x7fffffff) > 0x7f800000;
    return none ? -0.5 : optics_limit(height, 0.5);
}

float relief_texture_per_height(float texture_per_height)
{
    return optics_limit(optics_number(texture_per_height), 1e-6, 1024.0);
}

vec3 relief_position(ReliefRay ray, float t)
{
    return ray.start + t * ray.velocity;
}

ReliefHit relief_miss(ReliefRay ray)
{
    return ReliefHit(RELIEF_NONE, -1.0, relief_position(ray, ray.end), 0.0, ray.end);
}

// The ray from a position in the box along a direction of any length, in isotropic units. A zero
// vector, or one with a NaN in place of every component, points down. Starts outside the box are
// moved to its floor or top, texture coordinates are limited to +-65536, texture_per_height to
// 1e-6 .. 1024. No input yields NaN or infinity.
ReliefRay relief_ray(vec3 start, vec3 direction, float texture_per_height)
{
    vec3 d = vec3(relief_finite(direction.x, 1e18), relief_finite(direction.y, 1e18),
                  relief_finite(direction.z, 1e18));
    float longest = max(abs(d.x), max(abs(d.y), abs(d.z)));
    d = longest >= 1e-18 ? normalize(d / longest) : vec3(0.0, 0.0, -1.0);
    float scale = relief_texture_per_height(texture_per_height);

    ReliefRay ray;
    ray.start = vec3(relief_finite(start.x, 65536.0), relief_finite(start.y, 65536.0),
                     clamp(relief_finite(start.z, 1.0), -0.5, 0.5));
    ray.velocity = vec3(d.xy * scale, d.z);
    float room = d.z < 0.0 ? ray.start.z + 0.5 : 0.5 - ray.start.z;
    ray.end = room < RELIEF_MAX_WAY * abs(d.z) ? room / abs(d.z) : RELIEF_MAX_WAY;
    return ray;
}

// The eye's ray through the polygon's point uv, which lies in the middle of the box, from the box's
// top down. to_eye points from the surface to the eye; one from below the horizon, or along it, is
// raised to a slope of 1/64. Costs some 60 operations where the published start and step are 14:
// the limits, and a direction of unit length; nothing beside a search.
ReliefRay relief_view_ray(vec2 uv, vec3 to_eye, float texture_per_height)
{
    float x = relief_finite(to_eye.x, 1e18);
    float y = relief_finite(to_eye.y, 1e18);
    float flat_length = max(abs(x), abs(y));
    float z = max(relief_finite(to_eye.z, 1e18), flat_length / 64.0);
    vec2 tangent = z > 1e-18 ? vec2(x, y) / z : vec2(0.0);
    float scale = relief_texture_per_height(texture_per_height);
    return relief_ray(vec3(uv + 0.5 * scale * tangent, 0.5), vec3(-tangent, -1.0),
                      texture_per_height);
}

#endif
