// The techniques whose times the thesis and the paper list (thesis table 1, paper table 1), each on
// top of those before it: V. Timonen, Simulating and Rendering Translucent Layered Surfaces, 2006.
// With all of them a fragment is that of translucent_surface in translucent.glsl.
//
// The sources give the last program and the names of the steps that lead to it, not the programs in
// between. What stands in for a technique that is not there yet is told at each of them below. It
// is cheap, and made from what the earlier techniques have found: no compiler can drop those.
#ifndef ETALON_PUBLISHED_FULL_SCREEN
#define ETALON_PUBLISHED_FULL_SCREEN

#include "translucent.glsl"

const int NORMAL_AND_COLOR_MAPPING = 0;
const int LINEAR_SEARCH = 1;  // on the solid layer alone
const int BINARY_SEARCH = 2;
const int LINEAR_APPROXIMATION = 3;
const int TWO_LAYERS = 4;
const int RAY_CALCULATION = 5;  // of reflection and refraction
const int REFRACTION_LINEAR_SEARCH = 6;
const int REFRACTION_BINARY_SEARCH = 7;
const int REFRACTION_LINEAR_APPROXIMATION = 8;
const int ENVIRONMENT_MAPPING = 9;
const int LOCAL_SAMPLING = 10;  // of reflections
const int LOCAL_SAMPLE_LIGHTING = 11;
const int CORRECTED_SPECULAR_LIGHTING = 12;
const int OCCLUSION_LINEAR_SEARCH = 13;
const int OCCLUSION_BINARY_SEARCH = 14;
const int OCCLUSION_INTENSITY = 15;
const int HUED_REFRACTION = 16;
const int HUED_OCCLUDED_LIGHT = 17;

// What a ray sees before anything is looked up along it: its direction as a colour.
vec3 direction_color(vec3 ray)
{
    return 0.5 + 0.5 * ray;
}

// The point at which a ray meets the solid layer: samples at `first`, first + way, ... until one is
// below the layer, then `iterations` bisections, then one secant step. Without the last it is the
// bracket's lower end: with n steps for the box up to 2^-iterations / n of its height too low.
// Endless where no height is ever above the ray.
vec3 find_solid(vec3 first, vec3 way, int iterations, bool approximate)
{
    vec3 range2 = first;
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
    for (int i = 0; i < iterations; ++i) {
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
    if (!approximate) {
        return range2;
    }
    if (!sampled) {
        heights.x = solid_height(range1.xy);
    }
    return linearly_approximate(range1, range2, heights);
}

// find_solid along the eye's ray through the polygon's point uv.
vec3 find_solid_seen(vec2 uv, vec3 eye, float relative_height, ivec2 steps, bool approximate)
{
    vec3 way = search_step(eye, relative_height, steps.x);
    vec3 first = search_start(eye, relative_height) + way + vec3(uv, 0.0);
    return find_solid(first, way, steps.y, approximate);
}

// The light that reaches the solid layer at uv. Until its intensity is computed, a way of one
// through the layer takes all of it, and the layer's faces nothing; until the way out of the layer
// is refined, it ends at the first sample outside.
vec3 occluded_light(vec2 uv, TranslucentSurface surface, int techniques)
{
    bool refined = techniques >= OCCLUSION_BINARY_SEARCH;
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
        bool out_of_layer = under && translucent < at.z;
        if (out_of_layer || (!under && at.z < translucent)) {
            vec3 crossing = at;
            if (refined) {
                crossing = out_of_layer
                               ? refine_tlayer_int(at, at - way, surface.occlusion_search.y)
                               : refine_tlayer_int(at - way, at, surface.occlusion_search.y);
            }
            if (out_of_layer && techniques >= HUED_OCCLUDED_LIGHT) {
                left *= hued_transmittance(length(crossing - entry), surface.half_distance,
                                           surface.absorb_color);
            }
            if (techniques >= OCCLUSION_INTENSITY) {
                vec3 normal = decode_normal(translucent_normal_texel(crossing.xy));
                left *= out_of_layer
                            ? lamp_intensity(-normal, surface, surface.n1, surface.n2)
                            : lamp_intensity(normal, surface, surface.n2, surface.n1);
            } else if (out_of_layer) {
                left *= max(1.0 - length(crossing - entry), 0.0);
            }
            entry = crossing;
            under = !under;
        }
        at += way;
    }
    return left;
}

// The solid layer's colour at uv in the lamp's light, all of it until occlusion is searched.
vec3 solid_sample(vec2 uv, TranslucentSurface surface, int techniques)
{
    vec3 normal = decode_normal(solid_normal_texel(uv));
    vec3 left = vec3(1.0);
    if (techniques >= OCCLUSION_LINEAR_SEARCH && dot(normal, normalize(surface.light)) > 0.0) {
        left = occluded_light(uv, surface, techniques);
    }
    return solid_color(uv) * lamp_light(normal, left, surface);
}

// What the eye sees along the refracted ray: its direction, until it is followed.
vec3 refraction_sample(vec3 entry, vec3 ray, TranslucentSurface surface, int techniques)
{
    if (techniques < REFRACTION_LINEAR_SEARCH) {
        return direction_color(ray);
    }
    vec3 way = search_step(ray, surface.relative_height, surface.refraction_search.x);
    int iterations = techniques >= REFRACTION_BINARY_SEARCH ? surface.refraction_search.y : 0;
    vec3 range2 = search_start(ray, surface.relative_height);
    range2 += entry + way;
    vec3 point = find_solid(range2, way, iterations, techniques >= REFRACTION_LINEAR_APPROXIMATION);
    vec3 seen = solid_sample(point.xy, surface, techniques);
    if (techniques >= HUED_REFRACTION) {
        seen *= hued_transmittance(absorption_way(entry, point, surface), surface.half_distance,
                                   surface.absorb_color);
    }
    return seen;
}

// What the eye sees along the mirrored ray: its direction, until there are surroundings. There is
// no highlight at all before its corrected form.
vec3 reflection_sample(vec3 ray, vec3 point, vec3 normal, vec3 eye, TranslucentSurface surface,
                       int techniques)
{
    if (techniques < ENVIRONMENT_MAPPING) {
        return direction_color(ray);
    }
    bool local = false;
    vec2 uv = vec2(0.0);
    if (techniques >= LOCAL_SAMPLING && ray.z < 0.0) {
        uv = reflection_position(point, ray, surface);
        local = !(uv.x < 0.0 || uv.x > surface.extent || uv.y < 0.0 || uv.y > surface.extent);
    }
    vec3 seen = local ? solid_color(uv) : environment(ray);
    if (techniques >= LOCAL_SAMPLE_LIGHTING) {
        seen *= lamp_light(normal, vec3(1.0), surface);
    }
    if (techniques >= CORRECTED_SPECULAR_LIGHTING) {
        seen += surface.specular * half_vector_highlight(normal, normalize(eye),
                                                         normalize(surface.light), 400.0, 10.0);
    }
    return seen;
}

// The colour of a point of the translucent layer: red in the lamp's light, as the thesis shows it,
// until its rays are computed.
vec3 layer_sample(vec3 point, vec3 eye, TranslucentSurface surface, int techniques)
{
    vec3 normal = decode_normal(translucent_normal_texel(point.xy));
    if (techniques < RAY_CALCULATION) {
        return vec3(1.0, 0.0, 0.0) * lamp_light(normal, vec3(1.0), surface);
    }
    vec3 v = -normalize(eye);
    float cos_i = clamp(dot(v, -normal), 0.0, 1.0);
    vec3 refracted = composed_refraction_ray(v, -normal, surface.n1, surface.n2);
    vec3 reflected = composed_reflection_ray(v, -normal);
    return composed_radiance(reflection_sample(reflected, point, normal, eye, surface, techniques),
                             refraction_sample(point, refracted, surface, techniques), surface.n1,
                             surface.n2, cos_i);
}

// The colour of the fragment at uv with the techniques up to one of those above.
vec3 full_screen(vec2 uv, vec3 eye, TranslucentSurface surface, int techniques)
{
    if (techniques < LINEAR_SEARCH) {
        return solid_sample(uv, surface, techniques);
    }
    if (techniques < TWO_LAYERS) {
        int iterations = techniques >= BINARY_SEARCH ? surface.view_search.y : 0;
        vec3 seen = find_solid_seen(uv, eye, surface.relative_height,
                                    ivec2(surface.view_search.x, iterations),
                                    techniques >= LINEAR_APPROXIMATION);
        return solid_sample(seen.xy, surface, techniques);
    }
    vec3 point;
    int encounter = find_relief(point, surface.view_search.x, surface.view_search.y, eye, uv,
                                surface.relative_height);
    return encounter == 1 ? layer_sample(point, eye, surface, techniques)
                          : solid_sample(point.xy, surface, techniques);
}

#endif
