// How what the eye sees of the waves differs where the scene is mirrored, where its layers are
// exchanged, and from the solid alone. One call in a loop: programs of two take twice the time.
#include "translucent/compose.glsl"

TranslucentSurface surface();

// The mirrored scene is seen from the mirrored place, with the mirrored lamp.
vec3 change_by_mirroring(vec2 uv, vec3 eye)
{
    vec3 change = vec3(0.0);
    for (int i = 0; i < 2; ++i) {
        mirror_u = i == 0 ? 1.0 : -1.0;
        TranslucentSurface seen = surface();
        seen.lamp.x *= mirror_u;
        change = translucent_surface(vec2(mirror_u * uv.x, uv.y), vec3(mirror_u * eye.x, eye.yz),
                                     seen).rgb - change;
    }
    return change;
}

vec3 change_by_exchange(vec2 uv, vec3 eye)
{
    vec3 change = vec3(0.0);
    for (int i = 0; i < 2; ++i) {
        exchanged = i == 1;
        change = translucent_surface(uv, eye, surface()).rgb - change;
    }
    return change;
}

// From the solid where the eye's ray meets it, whatever is above.
vec3 change_by_layer(vec2 uv, vec3 eye)
{
    ReliefHit hit = find_layers(relief_view_ray(uv, eye, 0.1), RELIEF_SOLID,
                                surface().view_search.x, surface().view_search.y);
    return translucent_surface(uv, eye, surface()).rgb -
           assemble_surface_sample(hit.position.xy, surface());
}
