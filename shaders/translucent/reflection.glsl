// What is seen in the mirror of the layer's face.
#ifndef ETALON_TRANSLUCENT_REFLECTION
#define ETALON_TRANSLUCENT_REFLECTION

#include "../optics/plane.glsl"
#include "highlight.glsl"
#include "light.glsl"

// Where the mirrored ray from a point meets the solid layer, if that is the plane z =
// surface.plane: texture coordinates, and the way, -1 where the ray does not go down to it. The ray
// goes as far along the texture as those of the search. Over a solid that is d above or below the
// plane they err by d times the ray's slope.
// Source: thesis section 4.1.3, eqs. (21)-(25).
vec3 reflection_position(vec3 point, vec3 ray, TranslucentSurface surface)
{
    ReliefRay along = relief_ray(point, ray, surface.texture_per_height);
    float t = flat_layer_hit(surface.plane, along.start, along.velocity);
    t = t <= RELIEF_MAX_WAY ? t : -1.0;
    return t >= 0.0 ? vec3(relief_position(along, t).xy, t) : vec3(along.start.xy, -1.0);
}

// The same by a search of the solid, which costs 1 + refraction_search.x + .y samples at most.
vec3 reflection_hit(vec3 point, vec3 ray, TranslucentSurface surface)
{
    ReliefHit hit = find_layers(relief_ray(point, ray, surface.texture_per_height), RELIEF_SOLID,
                                surface.refraction_search.x, surface.refraction_search.y);
    return vec3(hit.position.xy, hit.t);
}

// What the mirrored ray shows: the solid where the ray meets it as surface.mirror says and there is
// surface, else the surroundings; and the highlight of the lamp, whose shadow is not looked for.
TranslucentSight reflection_sight(vec3 ray, vec3 point, vec3 normal, vec3 eye,
                                  TranslucentSurface surface)
{
    vec3 direction = translucent_direction(ray);
    vec3 local = vec3(0.0, 0.0, -1.0);
    if (surface.mirror == TRANSLUCENT_MIRROR_PLANE) {
        local = reflection_position(point, direction, surface);
    } else if (surface.mirror == TRANSLUCENT_MIRROR_SEARCH && direction.z < 0.0) {
        local = reflection_hit(point, direction, surface);
    }
    vec3 at = vec3(relief_finite(point.x, 65536.0), relief_finite(point.y, 65536.0),
                   relief_finite(point.z, 0.5));
    float highlight =
        half_vector_highlight(translucent_direction(normal), translucent_direction(eye),
                              translucent_to_lamp(at, surface), surface.gloss, surface.strength);
    vec3 light = translucent_light(surface.specular) * (highlight * translucent_fade(at, surface));
    if (local.z >= 0.0 && translucent_on_surface(local.xy, surface)) {
        return TranslucentSight(vec3(1.0), local.xy, light);
    }
    return TranslucentSight(vec3(0.0), vec2(0.0),
                            light + translucent_environment(direction, surface));
}

// The light that the mirrored ray brings to the point, without the face's share. normal is the
// face's, eye the direction to the eye. Error over flat layers: 3e-7 of the light, and that of
// half_vector_highlight.
// Costs the light's way to the mirrored point, which the published form leaves out; 1.2 to 1.7
// times that form where the environment is all that is mirrored.
// Source: thesis sections 4.1.3, 4.2.1, appendix A.2.
vec3 sample_reflection(vec3 ray, vec3 point, vec3 normal, vec3 eye, TranslucentSurface surface)
{
    return translucent_sight_light(reflection_sight(ray, point, normal, eye, surface), surface);
}

#endif
