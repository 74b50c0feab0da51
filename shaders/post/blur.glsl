// Smaller and softer pictures that keep their light.
//
// The picture is reached through `vec3 picture(vec2 uv)`; `texel` is the size of its texels in
// texture coordinates, which the picture is given as they come. Its values count as radiance, see
// hdr.glsl: whatever they are, none of the results is NaN or infinite.
#ifndef ETALON_POST_BLUR
#define ETALON_POST_BLUR

#include "hdr.glsl"

vec3 picture(vec2 uv);

const int POST_MAX_RADIUS = 64;

// The mean of the 2 x 2 texels around uv, a corner between four texels. Four reads at texel
// centres, so that the filter of the texture does not matter. Pictures of even size keep their
// mean exactly but for rounding, 2 ulp.
// Source: paper section 3.2.
vec3 downsample_box(vec2 uv, vec2 texel)
{
    vec2 h = 0.5 * texel;
    return 0.25 * ((post_radiance(picture(uv + vec2(-h.x, -h.y))) +
                    post_radiance(picture(uv + vec2(h.x, -h.y)))) +
                   (post_radiance(picture(uv + vec2(-h.x, h.y))) +
                    post_radiance(picture(uv + vec2(h.x, h.y)))));
}

// The mean of the 4 x 4 texels around uv, a corner, by four reads at corners: the texture must
// filter linearly. It forgives single bright texels that flicker. Error: 3 ulp and the filter's.
vec3 downsample_linear(vec2 uv, vec2 texel)
{
    return 0.25 * ((post_radiance(picture(uv + vec2(-texel.x, -texel.y))) +
                    post_radiance(picture(uv + vec2(texel.x, -texel.y)))) +
                   (post_radiance(picture(uv + vec2(-texel.x, texel.y))) +
                    post_radiance(picture(uv + vec2(texel.x, texel.y)))));
}

// exp(-x^2 / (2 sigma^2)), x and sigma in the same unit; sigma counts as at least 2^-20 and at most
// 2^20. A weight of NaN is 0, NaN counts as the least sigma. Error: 1e-6 absolute.
float gaussian_weight(float x, float sigma)
{
    float s = optics_limit(optics_number(sigma), 9.5367431640625e-7, 1048576.0);
    float ratio = optics_limit(x, 1e18) / s;
    // Beyond 16 sigma the weight is zero in any float.
    return abs(ratio) < 16.0 ? exp2(-0.72134752044448170 * ratio * ratio) : 0.0;
}

// One direction of a Gaussian blur: the mean of the 2 radius + 1 reads at uv + k * direction, in
// weights that sum to one: what is spread is neither lost nor gained. direction is one texel of the
// picture along x or y, sigma in texels, radius 0..64 (3 sigma leave 0.3 % of the bell out).
// A sigma of 0 or a radius of 0 gives picture(uv). Error: 1e-6 of the largest value read.
// Source: thesis 3.2.3, paper section 3.2.
vec3 gaussian_blur(vec2 uv, vec2 direction, float sigma, int radius)
{
    vec3 sum = post_radiance(picture(uv));
    float weights = 1.0;
    int reach = clamp(radius, 0, POST_MAX_RADIUS);
    for (int k = 1; k <= reach; ++k) {
        float weight = gaussian_weight(float(k), sigma);
        sum += weight * (post_radiance(picture(uv - float(k) * direction)) +
                         post_radiance(picture(uv + float(k) * direction)));
        weights += 2.0 * weight;
    }
    return sum / weights;
}

#endif
