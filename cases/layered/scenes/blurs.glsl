// Blurs that a family compares, of a map of 128 that is read as `picture` and as `inner_layer`.
#include "post/blur.glsl"

const float BLURS_TEXEL = 1.0 / 128.0;

vec3 inner_layer(vec2 uv, float level);

// Both passes of a separable blur where the map is a sum f(u) + g(v), without a picture between
// them: each pass leaves the other's part as it is.
float two_passes(vec2 uv, float sigma, int radius)
{
    return gaussian_blur(uv, vec2(BLURS_TEXEL, 0.0), sigma, radius).x +
           gaussian_blur(uv, vec2(0.0, BLURS_TEXEL), sigma, radius).x - picture(uv).x;
}

// The mean of four reads of a level, whose texels are r / 2 wide. Their boxes and the filter
// between them spread as a disc of r / 2 would; the reads' places do the rest of a disc of r.
float four_reads(vec2 uv, float r)
{
    float level = log2(0.5 * r);
    vec2 h = vec2(0.4330127 * r * BLURS_TEXEL, -0.4330127 * r * BLURS_TEXEL);
    return 0.25 * ((inner_layer(uv + h.xx, level).x + inner_layer(uv + h.xy, level).x) +
                   (inner_layer(uv + h.yx, level).x + inner_layer(uv + h.yy, level).x));
}
