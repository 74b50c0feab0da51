// A whole pixel of a surface with one layer below it.
#ifndef ETALON_LAYERED_COLOR
#define ETALON_LAYERED_COLOR

#include "blend.glsl"
#include "filter.glsl"
#include "transmission.glsl"

// No way through the medium is longer than this many times its depth.
const float LAYERED_LONGEST = 4.0;

// The light towards the eye, tangent space. `outer` is the outer layer's colour, with its
// transparency in alpha; `specular` what the environment shows along mirrored_vector(to_eye,
// normal); d the depth of the inner layer in texels of its map, texel_size (1 / width, 1 / height),
// n1 and n2 the indices outside and between the layers. No input yields NaN or infinity. Error:
// that of its parts; the inner layer's coordinate within 1e-5 d texels and 2 ulp.
// Source: Oat, second listing, with the parts of this folder.
vec3 layered_color(vec2 uv, vec3 to_eye, vec3 to_light, vec3 normal, vec4 outer, vec3 specular,
                   float d, vec2 texel_size, float n1, float n2)
{
    const vec3 up = vec3(0.0, 0.0, 1.0);
    to_eye = layered_unit(to_eye, up);
    to_light = layered_unit(to_light, up);
    normal = layered_unit(normal, up);
    float cosine = clamp(dot(normal, to_eye), 0.0, 1.0);

    vec3 transmission = transmission_vector(to_eye, normal, n1, n2);
    float longest = LAYERED_LONGEST * optics_limit(d, 0.0, 1e9);
    float s = transmission_distance(d, transmission, longest);
    vec3 inner = growable_filter_rgb(offset_coordinate(uv, s, transmission, texel_size),
                                     texel_size, blur_radius(s, 1.0));
    vec3 base = blend_layers(outer.rgb, inner, outer.a, cosine);
    return light_layers(base, dot(normal, to_light), specular,
                        fresnel_reflectance(n1, n2, cosine));
}

#endif
