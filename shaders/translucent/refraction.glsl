// What is seen through the layer's face: the refracted ray, down to the solid.
#ifndef ETALON_TRANSLUCENT_REFRACTION
#define ETALON_TRANSLUCENT_REFRACTION

#include "light.glsl"

// Where the refracted ray from `entry`, a point of the translucent layer, meets the solid. The
// search begins at the entry, so that no step is lost and nothing behind it is found; at
// refraction_search.x steps of the way down to the box's floor, it takes 1 + x + y samples at most.
// Later crossings of the translucent layer are not looked for. Error: that of find_layers. Costs
// 2.1 times the published form on llvmpipe: limits, a bound and the hit's record.
// Source: thesis section 4.1.2, appendix A.2.
ReliefHit refraction_hit(vec3 entry, vec3 ray, TranslucentSurface surface)
{
    return find_layers(relief_ray(entry, ray, surface.texture_per_height), RELIEF_SOLID,
                       surface.refraction_search.x, surface.refraction_search.y);
}

// What that ray shows: the solid or, where it meets none that is on the surface, the surroundings,
// less what the layer absorbs on the way.
TranslucentSight refraction_sight(vec3 entry, vec3 ray, TranslucentSurface surface)
{
    ReliefHit hit = refraction_hit(entry, ray, surface);
    bool solid = hit.layer != RELIEF_NONE && translucent_on_surface(hit.position.xy, surface);
    float way = solid ? hit.t : relief_ray(entry, ray, surface.texture_per_height).end;
    vec3 left = beer_lambert(way, surface.half_distance, surface.absorb_color);
    if (solid) {
        return TranslucentSight(left, hit.position.xy, vec3(0.0));
    }
    return TranslucentSight(vec3(0.0), vec2(0.0),
                            left * translucent_environment(translucent_direction(ray), surface));
}

// The light that comes along that ray to the entry, without the face's share. Absorption counts
// over the ray's way, a length in box heights, and over that to the box where no solid is met.
// Error over flat layers: 3e-7 of the light, and 2e-6 of the way in half distances.
// Source: thesis section 4.1.2, appendix A.2.
vec3 sample_refraction(vec3 entry, vec3 ray, TranslucentSurface surface)
{
    return translucent_sight_light(refraction_sight(entry, ray, surface), surface);
}

#endif
