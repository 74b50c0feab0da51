// Offset (parallax) mapping: a guess of the hit from one to a few samples, without a search.
//
// These always return a hit, the higher layer's where the last sample was taken (the solid's if
// both are as high), with all of the ray as its bracket. They are right on flat layers and wrong on
// what is steep or far off: of 500 rays at 0 to 45 degrees on bricks one offset is wrong by more
// than two texels for 3 %, the limited one for 3 %, four iterations for 6 %.
#ifndef ETALON_RELIEF_OFFSET
#define ETALON_RELIEF_OFFSET

#include "search.glsl"

vec3 solid_normal(vec2 uv);
vec3 translucent_normal(vec2 uv);

// The way to the middle of the box, where the polygon is; the start for a ray that comes from below
// it or does not descend.
float offset_start(ReliefRay ray)
{
    float down = -ray.velocity.z;
    return ray.start.z < RELIEF_MAX_WAY * down ? clamp(ray.start.z / down, 0.0, ray.end)
                                               : (down > 0.0 ? ray.end : 0.0);
}

// The heights of both layers above the ray after the way t, and the hit there.
ReliefHit offset_hit(ReliefRay ray, vec2 gaps, float t)
{
    float way = clamp(t, 0.0, ray.end);
    return ReliefHit(gaps.x > gaps.y ? RELIEF_TRANSLUCENT : RELIEF_SOLID, way,
                     relief_position(ray, way), 0.0, ray.end);
}

// How far a ray must go to fall by so much: without bound for one that hardly does, so at most to
// the ends of the box.
float offset_way(ReliefRay ray, float fall)
{
    float down = max(-ray.velocity.z, 1.0 / RELIEF_MAX_WAY);
    return fall / down;
}

// One step from the polygon to the height that was sampled there (Kaneko; thesis 1.3.2). Exact for
// flat layers.
ReliefHit offset_mapping(ReliefRay ray)
{
    float t = offset_start(ray);
    vec2 gaps = relief_gaps(ray, t, RELIEF_BOTH);
    return offset_hit(ray, gaps, t - offset_way(ray, max(gaps.x, gaps.y)));
}

// With the offset limited to the height (Welsh): no division by the cosine, so that the error at
// grazing angles is a flat image instead of a random one.
ReliefHit offset_mapping_limited(ReliefRay ray)
{
    float t = offset_start(ray);
    vec2 gaps = relief_gaps(ray, t, RELIEF_BOTH);
    return offset_hit(ray, gaps, t - max(gaps.x, gaps.y));
}

// So many steps, each from the last one's point. Converges where the map is less steep than the
// ray.
ReliefHit offset_mapping_iterated(ReliefRay ray, int iterations)
{
    int count = relief_steps(iterations);
    float t = offset_start(ray);
    vec2 gaps = vec2(0.0);
    for (int i = 0; i < count; ++i) {
        gaps = relief_gaps(ray, t, RELIEF_BOTH);
        t = clamp(t - offset_way(ray, max(gaps.x, gaps.y)), 0.0, ray.end);
    }
    return offset_hit(ray, gaps, t);
}

// The same along the surface's tangent plane instead of a horizontal one (Premecz): each step goes
// to where the ray meets the plane through the sample, with the normal in isotropic units. A step
// that the plane would send up or beyond the box's height is the horizontal one. Exact for a ramp.
ReliefHit offset_mapping_sloped(ReliefRay ray, float texture_per_height, int iterations)
{
    int count = relief_steps(iterations);
    float scale = relief_texture_per_height(texture_per_height);
    vec3 direction = vec3(ray.velocity.xy / scale, ray.velocity.z);
    float t = offset_start(ray);
    vec2 gaps = vec2(0.0);
    for (int i = 0; i < count; ++i) {
        vec2 uv = relief_position(ray, t).xy;
        gaps = relief_gaps(ray, t, RELIEF_BOTH);
        bool translucent = gaps.x > gaps.y;
        vec3 normal = translucent ? translucent_normal(uv) : solid_normal(uv);
        normal = optics_limit(optics_number(normal), 1e9);
        float gap = translucent ? gaps.x : gaps.y;
        float fall = -dot(normal, direction);
        float step_back = gap * normal.z / fall;
        float horizontal = offset_way(ray, gap);
        bool usable = fall > 0.0 && normal.z > 0.0 && abs(step_back) <= RELIEF_MAX_WAY;
        t = clamp(t - (usable ? step_back : horizontal), 0.0, ray.end);
    }
    return offset_hit(ray, gaps, t);
}

#endif
