// Several layers below a surface, each under a medium of its own.
//
// The scene gives each layer's colour and opacity (rgb and alpha, 0..1) at a texture coordinate and
// a mip level, and the medium above it: its thickness in texels and its index.
#ifndef ETALON_LAYERED_STACK
#define ETALON_LAYERED_STACK

#include "../optics/fresnel.glsl"
#include "transmission.glsl"

vec4 stack_layer(int layer, vec2 uv, float level);
vec2 stack_medium(int layer);

// Layers beyond these are not looked at.
const int LAYERED_MAX_LAYERS = 8;
// The way through a medium is at most this many times its thickness.
const float LAYERED_LONGEST_SLANT = 16.0;

// The light of a stack towards the eye: from the top down, what a layer does not cover passes to
// the next. The direction of sight is bent at the surface, by its normal, and at each layer, which
// are flat; what the change of index mirrors there is lost. A layer is blurred by a disc of
// `spread` texels of radius for each texel of the way to it, or rather by the mip level whose box
// and bilinear filters have that disc's second moment: one sample a layer. v and n as in
// transmission.glsl, n1 the index outside, texel_size (1 / width, 1 / height). Black at total
// internal reflection, and no brighter than the brightest layer. No input yields NaN or infinity.
// Error: 5e-7 of the brightest layer, and of a layer's coordinate 2e-5 of the way in texels.
// Source: Oat, results (the layers of Pharr's course notes) and the thesis' outlook, which
// names more than two; the rule is ours.
vec3 layered_stack(vec2 uv, vec3 v, vec3 n, float n1, int count, float spread, vec2 texel_size)
{
    const vec3 up = vec3(0.0, 0.0, 1.0);
    v = layered_unit(v, up);
    n = layered_unit(n, up);
    spread = optics_limit(spread, 0.0, 1024.0);

    float index = stack_medium(0).y;
    vec3 along = transmission_vector(v, n, n1, index);
    float clear = fresnel_transmittance(n1, index, dot(n, v));
    vec3 light = vec3(0.0);
    float way = 0.0;
    for (int i = 0; i < LAYERED_MAX_LAYERS; ++i) {
        if (i >= count || !(along.z < 0.0)) {
            break;
        }
        vec2 medium = stack_medium(i);
        if (i > 0) {
            clear *= fresnel_transmittance(index, medium.y, -along.z);
            along = refract_ray(along, up, index, medium.y);
            index = medium.y;
        }
        float thickness = optics_limit(medium.x, 0.0, 65536.0);
        float s = transmission_distance(thickness, along, LAYERED_LONGEST_SLANT * thickness);
        uv = offset_coordinate(uv, s, along, texel_size);
        way += s;
        float radius = way * spread;
        vec4 layer = stack_layer(i, uv, 0.5 * log2(1.0 + radius * radius));
        float opacity = optics_limit(layer.a, 0.0, 1.0);
        light += (clear * opacity) * optics_limit(layer.rgb, 0.0, 65504.0);
        clear *= 1.0 - opacity;
    }
    return light;
}

#endif
