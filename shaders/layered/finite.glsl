// What the functions of this folder do first with inputs that mean nothing.
#ifndef ETALON_LAYERED_FINITE
#define ETALON_LAYERED_FINITE

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// x where it is a number within +-limit, else the nearer bound; 0 for NaN.
float layered_finite(float x, float limit)
{
    return x >= -limit ? min(x, limit) : (x < 0.0 ? -limit : 0.0);
}

vec2 layered_finite(vec2 x, float limit)
{
    return vec2(layered_finite(x.x, limit), layered_finite(x.y, limit));
}

vec3 layered_finite(vec3 x, float limit)
{
    return vec3(layered_finite(x.xy, limit), layered_finite(x.z, limit));
}

// x limited to 0..limit; 0 for NaN.
float layered_positive(float x, float limit)
{
    return x > 0.0 ? min(x, limit) : 0.0;
}

// A colour: each channel 0 to 65504, the largest number of a 16-bit float; 0 for NaN.
vec3 layered_light(vec3 color)
{
    return vec3(layered_positive(color.r, 65504.0), layered_positive(color.g, 65504.0),
                layered_positive(color.b, 65504.0));
}

// v with a length of one; otherwise where v is shorter than 1e-18 or nothing but NaN.
vec3 layered_unit(vec3 v, vec3 otherwise)
{
    v = layered_finite(v, 1e18);
    float longest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    return longest >= 1e-18 ? normalize(v / longest) : otherwise;
}

#endif
