// The translucent surface: what the eye sees of a layer that reflects and refracts, over a solid.
#ifndef ETALON_TRANSLUCENT_COMPOSE
#define ETALON_TRANSLUCENT_COMPOSE

#include "reflection.glsl"
#include "refraction.glsl"

// The normal, or the nearest that is seen from there where it faces away from the eye, as normals
// between texels, or of another place than the hit's, may: the ray is then grazing, and none of the
// vectors that follow is without a length.
vec3 translucent_visible_normal(vec3 normal, vec3 to_eye)
{
    float away = dot(normal, to_eye);
    if (away >= 0.0) {
        return normal;
    }
    normal -= away * to_eye;
    normal = dot(normal, normal) > 1e-6 ? normalize(normal) : to_eye;
    return normalize(normal - min(dot(normal, to_eye), 0.0) * to_eye);
}

// What the eye sees at a point: the refracted and the mirrored ray's, by the shares of the face.
struct TranslucentView {
    TranslucentSight refracted;
    TranslucentSight mirrored;
};

const TranslucentSight TRANSLUCENT_DARK = TranslucentSight(vec3(0.0), vec2(0.0), vec3(0.0));

TranslucentSight translucent_times(float share, TranslucentSight sight)
{
    return TranslucentSight(share * sight.share, sight.uv, share * sight.light);
}

TranslucentView translucent_view(vec3 point, vec3 eye, TranslucentSurface surface)
{
    vec3 to_eye = translucent_direction(eye);
    vec2 uv = vec2(relief_finite(point.x, 65536.0), relief_finite(point.y, 65536.0));
    vec3 normal = translucent_visible_normal(translucent_direction(translucent_normal(uv)), to_eye);
    vec4 shares = optics_fresnel(surface.n1, surface.n2, dot(to_eye, normal));
    float mirrored = 0.5 * (shares.x + shares.y);
    float transmitted = 0.5 * (shares.z + shares.w);
    TranslucentView view = TranslucentView(TRANSLUCENT_DARK, TRANSLUCENT_DARK);
    if (transmitted > 0.0) {
        vec3 ray = refract_ray(-to_eye, normal, surface.n1, surface.n2);
        view.refracted = translucent_times(transmitted, refraction_sight(point, ray, surface));
    }
    if (mirrored > 0.0) {
        vec3 ray = reflect_ray(-to_eye, normal);
        view.mirrored =
            translucent_times(mirrored, reflection_sight(ray, point, normal, eye, surface));
    }
    return view;
}

vec3 translucent_view_light(TranslucentView view, TranslucentSurface surface)
{
    // No loop over the two: SwiftShader then takes a minute to compile it.
    return translucent_sight_light(view.refracted, surface) +
           translucent_sight_light(view.mirrored, surface);
}

// The light that comes to the eye from a point of the translucent layer: what the mirrored and the
// refracted ray bring, by the shares of the face. The shares sum to one, and light is as in
// material.glsl, so that neither the way in nor the way out needs a factor of the indices: in the
// eye's own medium, that of index n1, it is the radiance. At total internal reflection only the
// mirrored ray counts, for equal indices only the refracted one, which then is straight.
// Error over flat layers: 3e-7 of the light. Costs 2 to 8 times the published form on llvmpipe, and
// far more where all that a ray may meet is alike, for there a compiler leaves out the published
// searches.
// Source: thesis section 4.2.1, paper algorithm 1, appendix A.2.
vec3 compose_transparent(vec3 point, vec3 eye, TranslucentSurface surface)
{
    return translucent_view_light(translucent_view(point, eye, surface), surface);
}

// The whole fragment at the polygon's texture coordinates uv: the first layer along the eye's ray,
// and its light. rgb is the light, a is 1; all are 0 where the ray meets no layer or not within the
// surface's extent, so that its outline is the relief's and not the polygon's. eye is the direction
// to the eye, of any length, which a relief does not change along the ray; it counts as at least 1
// in 64 above the horizon. Where both layers are met at once the solid is.
// Error over flat layers: 3e-7 of the light; the searches' over others.
// Source: thesis appendix A.2, main.
vec4 translucent_surface(vec2 uv, vec3 eye, TranslucentSurface surface)
{
    ReliefRay ray = relief_view_ray(uv, eye, surface.texture_per_height);
    ReliefHit hit = find_relief(ray, surface.view_search.x, surface.view_search.y);
    if (hit.layer == RELIEF_NONE || !translucent_on_surface(hit.position.xy, surface)) {
        return vec4(0.0);
    }
    TranslucentView view = TranslucentView(
        TranslucentSight(vec3(1.0), hit.position.xy, vec3(0.0)), TRANSLUCENT_DARK);
    if (hit.layer == RELIEF_TRANSLUCENT) {
        float scale = relief_texture_per_height(surface.texture_per_height);
        vec3 to_eye = vec3(-ray.velocity.xy / scale, -ray.velocity.z);
        view = translucent_view(hit.position, to_eye, surface);
    }
    return vec4(translucent_view_light(view, surface), 1.0);
}

#endif
