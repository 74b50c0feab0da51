// The two-layer translucent surface of V. Timonen, Simulating and Rendering Translucent Layered
// Surfaces (thesis, 2006), chapter 4 and the shaders of appendix A, as published, flaws included.
// shaders/translucent has functions of the same names that are right. What the shader reads from
// globals is in a structure; eye is the direction to the eye in tangent space, of any length, uv
// the polygon fragment's texture coordinates.
//
// The scene gives heights as z, decoded; normals as texels, 0 .. 1; colours as they are.
#ifndef ETALON_PUBLISHED_TRANSLUCENT
#define ETALON_PUBLISHED_TRANSLUCENT

#include "optics.glsl"
#include "relief.glsl"
#include "surroundings.glsl"

vec3 solid_normal_texel(vec2 uv);
vec3 translucent_normal_texel(vec2 uv);
vec3 solid_color(vec2 uv);
vec3 environment(vec3 direction);

struct TranslucentSurface {
    float n1;                 // the index of what the light comes from, 1
    float n2;                 // the layer's, 1.6
    vec3 absorb_color;        // (1, 1, 0)
    float half_distance;      // 0.25
    float relative_height;    // half the box's height in texture coordinates, 0.05
    vec2 solid_box;           // the solid layer's scale and level, (0.2, -0.25)
    float extent;             // texture coordinates of the polygon are 0 .. 4
    vec3 light;               // to the light, in tangent space, of the light's distance
    vec3 attenuation;         // constant, linear and quadratic factor
    vec3 global_ambient;      // times the material
    vec3 ambient;             // the light's, times the material
    vec3 diffuse;             // the light's, times the material
    vec3 specular;            // the light's
    ivec2 view_search;        // linear and binary steps, (24, 6)
    ivec2 refraction_search;  // (8, 5)
    ivec2 occlusion_search;   // (16, 5)
};

// What an interface leaves of the lamp's light; the normal is on the side that the light goes to.
float lamp_intensity(vec3 normal, TranslucentSurface surface, float n1, float n2)
{
    return refraction_intensity(normal, normalize(surface.light), n1, n2);
}

// The share of the light, per channel, that reaches the solid layer at uv. Flaws: the exit of a
// layer at the box's very top is never met; lengths mix texture coordinates and box heights; a way
// out of the layer takes the direction outside for that inside.
// Source: section 4.2.2, paper algorithm 2, appendix A.2.
vec3 get_light_vector(vec2 uv, TranslucentSurface surface)
{
    vec3 left = vec3(1.0);
    vec3 way = search_start(surface.light, surface.relative_height) /
               float(surface.occlusion_search.x) * 2.0;
    vec3 at = vec3(uv, solid_height(uv));
    bool under = translucent_height(uv) > at.z;
    vec3 entry = at;
    at += way;
    while (at.z < 0.5 + way.z) {
        float translucent = translucent_height(at.xy);
        if (solid_height(at.xy) > at.z) {
            return vec3(0.0);
        }
        if (under && translucent < at.z) {
            vec3 crossing = refine_tlayer_int(at, at - way, surface.occlusion_search.y);
            left *= hued_transmittance(length(crossing - entry), surface.half_distance,
                                       surface.absorb_color);
            vec3 normal = -decode_normal(translucent_normal_texel(crossing.xy));
            left *= lamp_intensity(normal, surface, surface.n1, surface.n2);
            under = false;
        } else if (!under && at.z < translucent) {
            vec3 crossing = refine_tlayer_int(at - way, at, surface.occlusion_search.y);
            entry = crossing;
            vec3 normal = decode_normal(translucent_normal_texel(crossing.xy));
            left *= lamp_intensity(normal, surface, surface.n2, surface.n1);
            under = true;
        }
        at += way;
    }
    return left;
}

// The lamp's light on a surface with that normal: nothing but global_ambient where it is behind.
vec3 lamp_light(vec3 normal, vec3 left, TranslucentSurface surface)
{
    float cosine = max(dot(normal, normalize(surface.light)), 0.0);
    vec3 light = surface.global_ambient;
    if (cosine > 0.0) {
        light += (surface.diffuse * cosine + surface.ambient) *
                 light_attenuation(length(surface.light), surface.attenuation.x,
                                   surface.attenuation.y, surface.attenuation.z) *
                 left;
    }
    return light;
}

// The solid layer's colour at uv in the light that reaches it. Flaws: what passes of the lamp dims
// the ambient light too, which ends where the lamp is behind; the lamp's direction is that of the
// polygon's point.
// Source: appendix A.2.
vec3 assemble_surface_sample(vec2 uv, TranslucentSurface surface)
{
    vec3 normal = decode_normal(solid_normal_texel(uv));
    bool lit = dot(normal, normalize(surface.light)) > 0.0;
    vec3 left = lit ? get_light_vector(uv, surface) : vec3(0.0);
    return solid_color(uv) * lamp_light(normal, left, surface);
}

// Where the refracted ray from `entry` meets the solid layer. Flaws: the search begins half a box
// above the entry and wastes those steps, and finds what is behind it; a ray that goes up is
// followed backwards.
vec3 refraction_point(vec3 entry, vec3 ray, TranslucentSurface surface)
{
    vec3 range2 = search_start(ray, surface.relative_height);
    vec3 way = search_step(ray, surface.relative_height, surface.refraction_search.x);
    range2 += entry + way;
    vec2 heights;
    while (true) {
        heights.y = solid_height(range2.xy);
        if (heights.y > range2.z) {
            break;
        }
        range2 += way;
    }
    vec3 range1 = range2 - way;
    bool sampled = false;
    for (int i = 0; i < surface.refraction_search.y; ++i) {
        vec3 middle = (range1 + range2) * 0.5;
        float height = solid_height(middle.xy);
        if (height < middle.z) {
            range1 = middle;
            heights.x = height;
            sampled = true;
        } else {
            range2 = middle;
            heights.y = height;
        }
    }
    if (!sampled) {
        heights.x = solid_height(range1.xy);
    }
    return linearly_approximate(range1, range2, heights);
}

// The length that absorption takes for the way between two points. Flaw: texture coordinates and
// box heights are added.
float absorption_way(vec3 from, vec3 to, TranslucentSurface surface)
{
    return length(to - from);
}

// What the eye sees along the refracted ray.
// Source: section 4.1.2, appendix A.2.
vec3 sample_refraction(vec3 entry, vec3 ray, TranslucentSurface surface)
{
    vec3 point = refraction_point(entry, ray, surface);
    return assemble_surface_sample(point.xy, surface) *
           hued_transmittance(absorption_way(entry, point, surface), surface.half_distance,
                              surface.absorb_color);
}

// Where the mirrored ray meets the plane at half the height of the solid layer. Flaws: half as far
// along the surface as the search goes for the same ray; behind the start of a ray below the plane.
vec2 reflection_position(vec3 point, vec3 ray, TranslucentSurface surface)
{
    float t = flat_layer_ray_parameter(0.5 * surface.solid_box.x + surface.solid_box.y, point, ray);
    return point.xy + ray.xy * t * surface.relative_height;
}

// What the eye sees along the mirrored ray, and the lamp's highlight. Flaws: what is seen in the
// mirror is lit as if it lay on the mirror; the surroundings are looked up in tangent space; the
// highlight's size and strength are fixed.
// Source: sections 4.1.3, 4.2.1, appendix A.2.
vec3 sample_reflection(vec3 ray, vec3 point, vec3 normal, vec3 eye, TranslucentSurface surface)
{
    bool local = false;
    vec2 uv = vec2(0.0);
    if (ray.z < 0.0) {
        uv = reflection_position(point, ray, surface);
        local = !(uv.x < 0.0 || uv.x > surface.extent || uv.y < 0.0 || uv.y > surface.extent);
    }
    vec3 seen = local ? solid_color(uv) : environment(ray);
    float highlight =
        half_vector_highlight(normal, normalize(eye), normalize(surface.light), 400.0, 10.0);
    return seen * lamp_light(normal, vec3(1.0), surface) + surface.specular * highlight;
}

// The colour of a point of the translucent layer. Flaws: without value at total internal reflection
// and for equal indices at grazing angles; a normal that faces away gives rays that are none; the
// weights are those of the energy.
// Source: section 4.2.1, paper algorithm 1, appendix A.2.
vec3 compose_transparent(vec3 point, vec3 eye, TranslucentSurface surface)
{
    vec3 v = -normalize(eye);
    vec3 inward = -decode_normal(translucent_normal_texel(point.xy));
    float cos_i = clamp(dot(v, inward), 0.0, 1.0);
    vec3 refracted = composed_refraction_ray(v, inward, surface.n1, surface.n2);
    vec3 reflected = composed_reflection_ray(v, inward);
    return composed_radiance(sample_reflection(reflected, point, -inward, eye, surface),
                             sample_refraction(point, refracted, surface), surface.n1, surface.n2,
                             cos_i);
}

// The colour of the fragment at uv: the shader's main.
vec3 translucent_surface(vec2 uv, vec3 eye, TranslucentSurface surface)
{
    vec3 point;
    int encounter = find_relief(point, surface.view_search.x, surface.view_search.y, eye, uv,
                                surface.relative_height);
    return encounter == 1 ? compose_transparent(point, eye, surface)
                          : assemble_surface_sample(point.xy, surface);
}

struct TranslucentVertex {
    vec4 position;  // in clip space
    vec2 uv;
    vec3 eye;    // to the eye and to the light in tangent space, unnormalised
    vec3 light;
    vec3 diffuse;  // the lights' colours times the material's
    vec3 ambient;
    vec3 global_ambient;
};

// The vertex stage: the application prepares both directions.
// Source: appendix A.1.
TranslucentVertex translucent_vertex(mat4 object_to_clip, vec4 position, vec2 uv, vec3 eye,
                                     vec3 light, vec3 material_diffuse, vec3 material_ambient,
                                     vec3 light_diffuse, vec3 light_ambient, vec3 model_ambient)
{
    return TranslucentVertex(object_to_clip * position, uv, eye, light,
                             material_diffuse * light_diffuse, material_ambient * light_ambient,
                             model_ambient * material_ambient);
}

#endif
