// What the thesis says of normals, lamps, highlights, surroundings and scattering, as published.
// The functions keep the flaws that their hardened forms in shaders/optics and shaders/translucent
// do not have.
#ifndef ETALON_PUBLISHED_SURROUNDINGS
#define ETALON_PUBLISHED_SURROUNDINGS

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// The normal of a texel, its green channel pointing down. Flaws: the neutral texel of an eight-bit
// map is tilted, and a texel of 0.5 in every channel has no direction.
// Source: thesis appendix A.2.
vec3 decode_normal(vec3 texel)
{
    vec3 n = texel - vec3(0.5);
    n.y = -n.y;
    return normalize(n);
}

// Flaw: without factors a division by zero; a near lamp with a small constant is brighter than
// itself. Source: thesis appendix A.2.
float light_attenuation(float d, float constant, float linear, float quadratic)
{
    return 1.0 / (constant + linear * d + quadratic * d * d);
}

// Flaw: none where light and eye oppose each other. Source: thesis appendix A.2.
vec3 half_vector(vec3 to_eye, vec3 to_light)
{
    return normalize(to_eye + to_light);
}

// Flaw: shines where the light is below the horizon. A half vector that is no number is hidden by
// the max() of most drivers. Source: thesis 4.2.1 and appendix A.2 (exponent 400, strength 10).
float half_vector_highlight(vec3 n, vec3 to_eye, vec3 to_light, float exponent, float strength)
{
    return pow(max(dot(n, half_vector(to_eye, to_light)), 0.0), exponent) * strength;
}

// The direction in which a cube map is read. Flaw: right at the cube's centre only.
// Source: thesis 3.3.1.
vec3 environment_direction(vec3 position, vec3 direction)
{
    return direction;
}

// Where a reflection or refraction map is read: the screen's own place, shifted by the normal's
// tilt. Flaws: leaves the map where the shift is large, and knows no depth.
// Source: thesis 3.3.2.
vec2 screen_map_position(vec2 screen, vec3 n, float strength)
{
    return screen + strength * n.xy;
}

// The size of the map for level n of equation (20), n = 1, 2, ... Flaw: the smallest map of the
// list beside it, of one texel, has no n.
float scattering_map_size(int n)
{
    return exp2(float(max(n, 1)));
}

// How far between two key maps of blur s_lower and s_upper the blur s lies: linearly. Flaw: blurs
// add in their squares, so the mixed map is too soft.
// Source: thesis 3.2.3.
float scattering_blend(float s, float s_lower, float s_upper)
{
    return (s - s_lower) / (s_upper - s_lower);
}

#endif
