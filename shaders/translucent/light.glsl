// A lamp's light on its way through the layer to the solid, and the solid's colour in it.
#ifndef ETALON_TRANSLUCENT_LIGHT
#define ETALON_TRANSLUCENT_LIGHT

#include "../optics/absorption.glsl"
#include "../optics/fresnel.glsl"
#include "../relief/refine.glsl"
#include "material.glsl"

// After so many crossings no light is left.
const int TRANSLUCENT_MAX_CROSSINGS = 16;

// The way at which the ray crosses the translucent layer's height between `outside` and `inside`,
// whichever is first: bisections, then a secant step.
float translucent_crossing(ReliefRay ray, float outside, float inside, int iterations)
{
    float gap_outside = relief_gaps(ray, outside, RELIEF_TRANSLUCENT).x;
    float gap_inside = relief_gaps(ray, inside, RELIEF_TRANSLUCENT).x;
    int count = relief_refinements(iterations);
    for (int i = 0; i < count; ++i) {
        float middle = 0.5 * (outside + inside);
        float gap = relief_gaps(ray, middle, RELIEF_TRANSLUCENT).x;
        if (gap < 0.0) {
            outside = middle;
            gap_outside = gap;
        } else {
            inside = middle;
            gap_inside = gap;
        }
    }
    return outside + (inside - outside) * relief_crossing(gap_outside, gap_inside);
}

// The unit direction to the lamp inside the layer, under a face with that normal; zero where no
// light from there enters.
vec3 translucent_inner_direction(vec3 to_lamp, vec3 normal, TranslucentSurface surface)
{
    return surface.light_way == TRANSLUCENT_LIGHT_REFRACTED
               ? refract_ray(to_lamp, normal, surface.n1, surface.n2)
               : to_lamp;
}

// The share of the lamp's light, per channel, that reaches the solid layer at uv: the product, over
// all places where the way there crosses the translucent layer's face, of the share that passes
// the face, and of what is left by the ways in between. 0 where the solid is in the way or the lamp
// not above the surface's horizon, 1 where nothing is in the way.
//
// Each face's share is that for the lamp's direction outside, which is the same for light on its
// way in and on its way out, so that no total reflection comes up where there is none. With
// TRANSLUCENT_LIGHT_STRAIGHT the ray goes straight on, and its ways in the layer are too long by
// the quotient of the slopes; with TRANSLUCENT_LIGHT_REFRACTED it is bent at each face, exactly
// where the faces that a ray passes are parallel. A ray that is in the layer still at the box's top
// leaves it there, as in a map that is white; beyond 16 faces only the solid counts.
//
// Error over flat layers: 2e-7. Over others it is that of the search: what lies between two
// samples is not seen. 2 samples for each of light_search.x steps (of every part of a bent ray),
// and light_search.y + 2 for each crossing. Costs 3 to 5 times the published
// form on llvmpipe: each face's accurate share, and the refraction there, which is executed even
// where it is not asked for.
// Source: thesis section 4.2.2, paper algorithm 2, appendix A.2.
vec3 get_light_vector(vec2 uv, TranslucentSurface surface)
{
    vec2 start = vec2(relief_finite(uv.x, 65536.0), relief_finite(uv.y, 65536.0));
    vec3 point = vec3(start, relief_height(solid_height(start)));
    vec3 to_lamp = translucent_to_lamp(point, surface);
    if (to_lamp.z <= 0.0) {
        return vec3(0.0);
    }
    bool under = relief_height(translucent_height(start)) > point.z;
    vec3 normal = under ? translucent_direction(translucent_normal(start)) : vec3(0.0, 0.0, 1.0);
    int steps = relief_steps(surface.light_search.x);
    int most = steps * (TRANSLUCENT_MAX_CROSSINGS + 1);
    ReliefRay ray;
    bool begins = true;
    float way = 0.0;
    float t = 0.0;
    float entry = 0.0;
    int crossings = 0;
    vec3 left = vec3(1.0);
    for (int i = 0; i < most && (begins || t < ray.end); ++i) {
        if (begins) {
            vec3 direction =
                under ? translucent_inner_direction(to_lamp, normal, surface) : to_lamp;
            if (direction.z <= 0.0) {
                return vec3(0.0);
            }
            ray = relief_ray(point, direction, surface.texture_per_height);
            way = ray.end / float(steps);
            t = 0.0;
            entry = 0.0;
            begins = false;
        }
        float next = t + way < 0.99999 * ray.end ? t + way : ray.end;
        bool at_end = next >= ray.end;
        vec2 gaps = relief_gaps(ray, next, RELIEF_BOTH);
        if (gaps.y > 0.0 && !at_end) {
            return vec3(0.0);
        }
        bool inside = gaps.x >= 0.0 && !at_end;
        if (inside != under && crossings < TRANSLUCENT_MAX_CROSSINGS) {
            // At the end the layer may be above the ray still: its face is there, and nothing
            // between.
            float crossing = next;
            if (gaps.x < 0.0 || !under) {
                crossing = translucent_crossing(ray, under ? next : t, under ? t : next,
                                                surface.light_search.y);
            }
            point = relief_position(ray, crossing);
            normal = translucent_direction(translucent_normal(point.xy));
            left *= fresnel_transmittance(surface.n1, surface.n2, abs(dot(normal, to_lamp)));
            if (under) {
                left *= beer_lambert(crossing - entry, surface.half_distance,
                                     surface.absorb_color);
            }
            under = inside;
            entry = crossing;
            ++crossings;
            begins = surface.light_way == TRANSLUCENT_LIGHT_REFRACTED && !at_end;
        }
        t = next;
    }
    return left;
}

// How much the lamp lights the solid, of what passes the layer: the cosine, and (n1 / n2)^2 within
// the layer. In a layer with TRANSLUCENT_LIGHT_REFRACTED the light spreads over the face
// above first, and is then bent.
float translucent_irradiance(vec3 point, vec3 normal, TranslucentSurface surface)
{
    vec3 to_lamp = translucent_to_lamp(point, surface);
    float cosine = dot(normal, to_lamp);
    if (relief_height(translucent_height(point.xy)) > point.z) {
        float ratio = optics_clamp_index(surface.n1) / optics_clamp_index(surface.n2);
        if (surface.light_way == TRANSLUCENT_LIGHT_REFRACTED) {
            vec3 face = translucent_direction(translucent_normal(point.xy));
            vec3 inner = translucent_inner_direction(to_lamp, face, surface);
            float spread = abs(dot(face, to_lamp));
            cosine = dot(normal, inner) * min(spread / max(abs(dot(face, inner)), 1e-6), 1024.0);
        }
        cosine *= ratio * ratio;
    }
    return max(cosine, 0.0);
}

// The solid's colour at uv in the light that reaches it: the light from everywhere and the lamp's
// that passes the layer, a Lambertian surface's. Light as material.glsl has it: within the layer
// the lamp's part is less by (n1 / n2)^2. The light from everywhere is not dimmed by the layer.
// Error over flat layers: 3e-7 of the light. Costs 4.5 to 5.5 times the published form on llvmpipe,
// nearly all of it get_light_vector's.
// Source: thesis appendix A.2.
vec3 assemble_surface_sample(vec2 uv, TranslucentSurface surface)
{
    vec2 at = vec2(relief_finite(uv.x, 65536.0), relief_finite(uv.y, 65536.0));
    vec3 point = vec3(at, relief_height(solid_height(at)));
    vec3 normal = translucent_direction(solid_normal(at));
    float fade = translucent_fade(point, surface);
    float cosine = translucent_irradiance(point, normal, surface);
    vec3 light =
        translucent_light(surface.global_ambient) + fade * translucent_light(surface.ambient);
    if (cosine > 0.0) {
        light += (fade * cosine) * translucent_light(surface.diffuse) *
                 get_light_vector(at, surface);
    }
    return optics_limit(solid_color(at), 0.0, 1.0) * light;
}

// What a ray shows: `share`, per channel, of the solid's colour at uv, and `light` beside it.
struct TranslucentSight {
    vec3 share;
    vec2 uv;
    vec3 light;
};

vec3 translucent_sight_light(TranslucentSight sight, TranslucentSurface surface)
{
    return sight.light + (sight.share != vec3(0.0)
                              ? sight.share * assemble_surface_sample(sight.uv, surface)
                              : vec3(0.0));
}

#endif
