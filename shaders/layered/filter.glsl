// The inner layer as it is seen through a scattering medium: a blur that grows with the way.
//
// The scene gives the layer's colour at a texture coordinate and a mip level; a layer without mip
// levels ignores the second.
#ifndef ETALON_LAYERED_FILTER
#define ETALON_LAYERED_FILTER

#include "../optics/limit.glsl"

vec3 inner_layer(vec2 uv, float level);

// The largest blur, in texels.
const float LAYERED_MAX_RADIUS = 1024.0;
// Up to this radius the filter reads level 0; beyond, a texel is a quarter of the radius.
const float LAYERED_FINE_RADIUS = 4.0;

// The radius of the blur after the way s, in the unit of s: `spread` is the radius that the medium
// adds per length, 1 in the article. 0 to LAYERED_MAX_RADIUS, whatever the inputs. Error: 1 ulp.
// Source: Oat, second listing, where radius and way are the same.
float blur_radius(float s, float spread)
{
    return min(optics_limit(s, 0.0, 1e18) * optics_limit(spread, 0.0, 1e18), LAYERED_MAX_RADIUS);
}

// A turn of the filter for a pixel, (cosine, sine) of an angle that is evenly distributed and
// uncorrelated between pixels: what would be the same error in all of them becomes noise. The
// length is one within 1e-6.
vec2 filter_rotation(ivec2 pixel)
{
    // Two rounds of a permuted congruential generator, one for each coordinate.
    uint state = uint(pixel.x) * 747796405u + 2891336453u;
    state = (((state >> ((state >> 28) + 4u)) ^ state) * 277803737u) ^ uint(pixel.y);
    state = state * 747796405u + 2891336453u;
    state = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    state = (state >> 22) ^ state;
    float angle = float(state >> 8) * (6.2831853 / 16777216.0) - 3.1415927;
    return normalize(vec2(cos(angle), sin(angle)));
}

// The mean over a disc of `radius` texels about uv, from 13 samples of equal weight. texel_size is
// (1 / width, 1 / height). rotation turns the samples; it should have unit length and is limited to
// +-1 in each component. radius is limited to 0..LAYERED_MAX_RADIUS, texture coordinates to
// +-65536, texel_size to 0..1024; the result to +-65504 in each channel. Radius 0 is the layer
// itself.
//
// The samples are the article's, moved and stretched so that their mean is (0, 0) and their second
// moments are those of the disc, r^2 / 4 in every direction: what is constant, linear or quadratic
// in uv is filtered as by the disc but for 5e-6 of the largest colour. A wave of k radians per
// texel is off by 0.0045 (k r)^3 for k r <= 1. Thirteen samples cannot follow finer ones; the disc
// leaves 2 J1(k r) / (k r). The worst direction's error, up to LAYERED_FINE_RADIUS:
//   k r up to    3       3.83    7.02    10.17   12.57 (a wave of 2 texels at r = 4)
//   here         0.07    0.10    0.17    0.47    0.59
//   published    0.28    0.28    0.28    0.55    0.77
// Beyond that radius it is 0.4 for any wave. From k r = 3.83 on the published samples are nearer
// in 4 to 5 of 10 directions, and for single waves by far: 0.07 instead of 0.29 at k r = 10.17,
// 0.01 instead of 0.56 at 12.36.
// Beyond LAYERED_FINE_RADIUS mip levels take over, as wide as a quarter of the radius; what their
// box and bilinear filters add to the second moment is taken off the samples' reach.
// Costs what the published filter does, 13 samples, and the limits: 1.1 to 1.5 times as much where
// a sample is a formula and costs next to nothing.
// Source: Oat, first listing (the samples); the moments and the levels are ours.
vec3 growable_filter_rgb(vec2 uv, vec2 texel_size, float radius, vec2 rotation)
{
    const vec2 taps[13] = vec2[13](
        vec2(-0.276078947, -0.263499923), vec2(-0.743652360, 0.096566960),
        vec2(-0.666084691, 0.588756137), vec2(-0.259393134, 0.701927788),
        vec2(0.806486412, -0.173850749), vec2(0.413368210, -0.402822009),
        vec2(0.345450133, 0.778879674), vec2(0.202900089, -0.770822170),
        vec2(0.395592810, 0.111903737), vec2(0.697944572, 0.409355770),
        vec2(-0.227131124, -0.764738991), vec2(-0.657081951, -0.405939155),
        vec2(-0.032320018, 0.094282932));

    uv = optics_limit(uv, 65536.0);
    rotation = optics_limit(rotation, 1.0);
    radius = optics_limit(radius, 0.0, LAYERED_MAX_RADIUS);
    float reach = radius;
    float level = 0.0;
    if (radius > LAYERED_FINE_RADIUS) {
        float texel = radius / LAYERED_FINE_RADIUS;
        level = log2(texel);
        reach = sqrt(radius * radius - texel * texel + 1.0);
    }
    vec2 size = vec2(optics_limit(texel_size.x, 0.0, 1024.0),
                     optics_limit(texel_size.y, 0.0, 1024.0));
    vec2 across = reach * rotation;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 13; ++i) {
        vec2 turned = vec2(taps[i].x * across.x - taps[i].y * across.y,
                           taps[i].x * across.y + taps[i].y * across.x);
        sum += inner_layer(uv + size * turned, level);
    }
    return optics_limit(sum / 13.0, 65504.0);
}

// As above, with the samples as they stand.
vec3 growable_filter_rgb(vec2 uv, vec2 texel_size, float radius)
{
    return growable_filter_rgb(uv, texel_size, radius, vec2(1.0, 0.0));
}

#endif
