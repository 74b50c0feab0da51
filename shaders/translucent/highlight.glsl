// The mirror image of a lamp on a surface.
#ifndef ETALON_TRANSLUCENT_HIGHLIGHT
#define ETALON_TRANSLUCENT_HIGHLIGHT

#include "../optics/limit.glsl"

// The unit vector that halves the angle between two unit vectors; the zero vector where they oppose
// each other (their sum shorter than 1e-6, or no number). Error: 3e-7 per component, over the sum's
// length.
vec3 half_vector(vec3 to_eye, vec3 to_light)
{
    vec3 h = to_eye + to_light;
    float h_h = optics_number(dot(h, h));
    return h_h > 1e-12 && h_h < 1e12 ? h * inversesqrt(h_h) : vec3(0.0);
}

// Blinn's highlight, strength * (n . h)^exponent, where h halves the angle between to_eye and
// to_light. All vectors are unit vectors that point away from the surface. strength, at least 0, is
// how much brighter the lamp is than what the display shows as white: the highlight is multiplied
// by it before the reflected share, so that a bright lamp stays bright in a weak mirror. exponent
// counts as 1..4096. Where a cosine is no number nothing shines; another NaN counts as the least.
// Nothing shines where the light or the eye is below the horizon (the published form adds up to its
// strength there), or where they oppose each other and no half vector is. Error: (n . h)'s rounding
// of 3e-7 grows by the exponent: 3e-7 exponent, relative; and 1e-30 of the strength. Costs 2 to 3
// times the published form: the horizon, and limits for exp2 and log2.
// Source: thesis 4.2.1 and appendix A.2, paper 3.2.
float half_vector_highlight(vec3 n, vec3 to_eye, vec3 to_light, float exponent, float strength)
{
    float n_l = optics_number(dot(n, to_light));
    float n_e = optics_number(dot(n, to_eye));
    if (n_l <= 0.0 || n_e <= 0.0) {
        return 0.0;
    }
    float cosine = optics_limit(optics_number(dot(n, half_vector(to_eye, to_light))), 0.0, 1.0);
    float power = optics_limit(optics_number(exponent), 1.0, 4096.0);
    float gain = optics_limit(optics_number(strength), 0.0, 65504.0);
    return cosine > 0.0 ? gain * exp2(max(power * log2(cosine), -126.0)) : 0.0;
}

#endif
