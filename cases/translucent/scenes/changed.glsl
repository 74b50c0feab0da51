// What the eye sees of the waves, mirrored, exchanged, and without the translucent layer.
#include "translucent/compose.glsl"

TranslucentSurface surface();

vec3 seen_as_it_is(vec2 uv, vec3 eye)
{
    return translucent_surface(uv, eye, surface()).rgb;
}

// The mirrored scene, from the mirrored place: the same.
vec3 seen_mirrored(vec2 uv, vec3 eye)
{
    vec3 across = vec3(-1.0, 1.0, 1.0);
    TranslucentSurface mirrored = surface();
    mirrored.lamp.x = -mirrored.lamp.x;
    mirror_u = -1.0;
    vec3 seen = translucent_surface(vec2(-uv.x, uv.y), across * eye, mirrored).rgb;
    mirror_u = 1.0;
    return seen;
}

vec3 seen_exchanged(vec2 uv, vec3 eye)
{
    exchanged = true;
    vec3 seen = translucent_surface(uv, eye, surface()).rgb;
    exchanged = false;
    return seen;
}

// The solid where the eye's ray meets it, whatever is above.
vec3 seen_solid(vec2 uv, vec3 eye)
{
    ReliefRay ray = relief_view_ray(uv, eye, 0.1);
    ReliefHit hit = find_layers(ray, RELIEF_SOLID, surface().view_search.x,
                                surface().view_search.y);
    return assemble_surface_sample(hit.position.xy, surface());
}
