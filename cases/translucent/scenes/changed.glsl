// How what the eye sees of the waves differs where the scene is mirrored, where its layers are
// exchanged, and from the solid alone.
#include "translucent/compose.glsl"

TranslucentSurface surface();

// The mirrored scene is seen from the mirrored place, with the mirrored lamp.
vec3 change_by_mirroring(vec2 uv, vec3 eye)
{
    TranslucentSurface seen = surface();
    vec3 change = translucent_surface(uv, eye, seen).rgb;
    mirror_u = -1.0;
    seen.lamp.x = -seen.lamp.x;
    return translucent_surface(vec2(-uv.x, uv.y), vec3(-eye.x, eye.yz), seen).rgb - change;
}

vec3 change_by_exchange(vec2 uv, vec3 eye)
{
    vec3 change = translucent_surface(uv, eye, surface()).rgb;
    exchanged = true;
    return translucent_surface(uv, eye, surface()).rgb - change;
}

// From the solid where the eye's ray meets it, whatever is above.
vec3 change_by_layer(vec2 uv, vec3 eye)
{
    ReliefHit hit = find_layers(relief_view_ray(uv, eye, 0.1), RELIEF_SOLID,
                                surface().view_search.x, surface().view_search.y);
    return translucent_surface(uv, eye, surface()).rgb -
           assemble_surface_sample(hit.position.xy, surface());
}
