// How the colours of two layers and of the mirrored environment become one.
//
// Colours are limited to 0..65504 in each channel and shares to 0..1, a NaN to the
// limit on the side of its sign. No input yields NaN or infinity. Where no colour is above one,
// none that is returned is above 1 + 2^-23. Errors are relative to the result, also where a dark
// colour stands beside a bright one: no share is made by a subtraction that cancels.
#ifndef ETALON_LAYERED_BLEND
#define ETALON_LAYERED_BLEND

#include "../optics/fresnel.glsl"

// The largest number of a 16-bit float.
const float LAYERED_BRIGHTEST = 65504.0;

// The sum of both by their shares.
vec3 layered_mix(vec3 outer, float outer_share, vec3 inner, float inner_share)
{
    return optics_limit(outer, 0.0, LAYERED_BRIGHTEST) * outer_share +
           optics_limit(inner, 0.0, LAYERED_BRIGHTEST) * inner_share;
}

// Outer and inner layer by the transparency of the outer one and the cosine between normal and eye:
// the inner layer's share is transparency * n_dot_v, as the article's text has it (its listing
// squares the cosine, which hides the inner layer earlier). Error: 4 ulp. Costs 1.4 times
// the published form: the limits.
// Source: Oat, section "Inner Surface Layer", last paragraph.
vec3 blend_layers(vec3 outer, vec3 inner, float transparency, float n_dot_v)
{
    float through = optics_limit(transparency, 0.0, 1.0);
    float cosine = optics_limit(n_dot_v, 0.0, 1.0);
    // 1 - through * cosine, which cancels, by two terms that do not.
    float outer_share = (1.0 - through) + through * (1.0 - cosine);
    return layered_mix(outer, outer_share, inner, through * cosine);
}

// As above by physics: the inner layer's share is transparency * T, with the share T of the light
// that passes the surface between the indices n1 outside and n2 inside at that cosine. T is 0 along
// the surface, 1 for equal indices (along the surface as well) and falls late: for 1.33 it is 0.94
// at 60 degrees, where n_dot_v is 0.5. Error: 20 ulp. Costs a Fresnel term more.
vec3 blend_layers_fresnel(vec3 outer, vec3 inner, float transparency, float n1, float n2,
                          float n_dot_v)
{
    float through = optics_limit(transparency, 0.0, 1.0);
    vec4 shares = optics_fresnel(n1, n2, n_dot_v);
    float mirrored = 0.5 * (shares.x + shares.y);
    float passed = 0.5 * (shares.z + shares.w);
    return layered_mix(outer, (1.0 - through) + through * mirrored, inner, through * passed);
}

// The light that leaves the surface: the mirrored environment by the share that is mirrored, the
// layers' colour, lit at the cosine n_dot_l, by the rest. reflectance is fresnel_reflectance at the
// eye's cosine; 0 leaves the diffuse light alone. Error: 4 ulp. Costs 2.4 to 3.4 times the
// published form: the shares and the limits.
// Source: Oat, end of the second listing; the shares, which keep the sum within one, are ours.
vec3 light_layers(vec3 base, float n_dot_l, vec3 specular, float reflectance)
{
    float mirrored = optics_limit(reflectance, 0.0, 1.0);
    // Unlimited, Mesa's compiler takes base out of both shares, base + mirrored (specular - base),
    // and the difference swallows a dark colour beside a bright one.
    float rest = optics_limit(1.0 - mirrored, 0.0, 1.0);
    return layered_mix(base, rest * optics_limit(n_dot_l, 0.0, 1.0), specular, mirrored);
}

#endif
