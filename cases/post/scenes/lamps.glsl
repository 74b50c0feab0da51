// An 8 x 8 picture that repeats, dark but for a few lamps; and sums over all of its texels.
#include "shaders/post/bloom.glsl"
#include "shaders/post/blur.glsl"

uniform int lamps;
uniform float brightness;

const vec2 TEXEL = vec2(0.125);

vec3 picture(vec2 uv)
{
    ivec2 at = ivec2(floor(uv * 8.0)) & 7;
    int place = 8 * at.y + at.x;
    bool lit = (place * lamps) % 11 == 3;
    return lit ? vec3(brightness, 0.5 * brightness, 3.0) : vec3(0.25, 0.5, 1.5);
}

vec2 center(int place)
{
    return (vec2(float(place & 7), float(place >> 3)) + 0.5) * TEXEL;
}

vec3 total()
{
    vec3 sum = vec3(0.0);
    for (int place = 0; place < 64; ++place) {
        sum += picture(center(place));
    }
    return sum;
}

vec3 total_blurred(float sigma, int radius)
{
    vec3 sum = vec3(0.0);
    for (int place = 0; place < 64; ++place) {
        sum += gaussian_blur(center(place), vec2(TEXEL.x, 0.0), sigma, radius);
    }
    return sum;
}

vec3 total_halved()
{
    vec3 sum = vec3(0.0);
    for (int place = 0; place < 16; ++place) {
        vec2 corner = (vec2(float(place & 3), float(place >> 2)) * 2.0 + 1.0) * TEXEL;
        sum += 4.0 * downsample_box(corner, TEXEL);
    }
    return sum;
}

// The bright part's blur along y at a texel.
vec3 blurred_high(vec2 uv, float limit, float sigma, int radius)
{
    vec3 sum = hdr_high(picture(uv), limit);
    float weights = 1.0;
    for (int k = 1; k <= radius; ++k) {
        vec2 d = vec2(0.0, float(k) * TEXEL.y);
        float weight = gaussian_weight(float(k), sigma);
        sum += weight * (hdr_high(picture(uv - d), limit) + hdr_high(picture(uv + d), limit));
        weights += 2.0 * weight;
    }
    return sum / weights;
}

vec3 total_bloom(float limit, float share, float sigma, int radius)
{
    vec3 sum = vec3(0.0);
    for (int place = 0; place < 64; ++place) {
        vec2 uv = center(place);
        sum += bloom(picture(uv), blurred_high(uv, limit, sigma, radius), limit, share);
    }
    return sum;
}
