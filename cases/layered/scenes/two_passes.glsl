#include "post/blur.glsl"

// Both passes of a separable blur over a map of 128 that is a sum f(u) + g(v), without a picture
// between them: each pass leaves the other's part as it is.
float two_passes(vec2 uv, float sigma, int radius)
{
    const float texel = 1.0 / 128.0;
    return gaussian_blur(uv, vec2(texel, 0.0), sigma, radius).x +
           gaussian_blur(uv, vec2(0.0, texel), sigma, radius).x - picture(uv).x;
}
