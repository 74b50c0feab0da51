// Inputs of any bits, brought into a range.
//
// What clamp, min, max and comparisons make of NaN is open, and differs between drivers. Floats of
// one sign are ordered like their bits, so that these limits are set in integers: NaN is beyond
// infinity, on the side of its sign bit; optics_number makes it 0 first, where that is the better
// choice. low and limit are numbers, not negative; no result of a limit is a NaN.
#ifndef ETALON_OPTICS_LIMIT
#define ETALON_OPTICS_LIMIT

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// x in low .. high, 0 <= low. What is negative, -0 and NaN with a sign included, yields low.
float optics_limit(float x, float low, float high)
{
    return intBitsToFloat(clamp(floatBitsToInt(x), floatBitsToInt(low), floatBitsToInt(high)));
}

vec3 optics_limit(vec3 x, float low, float high)
{
    return intBitsToFloat(clamp(floatBitsToInt(x), floatBitsToInt(low), floatBitsToInt(high)));
}

// x in -limit .. limit.
float optics_limit(float x, float limit)
{
    int bits = floatBitsToInt(x);
    int magnitude = min(bits & 0x7fffffff, floatBitsToInt(limit));
    return intBitsToFloat(magnitude | (bits & ~0x7fffffff));
}

vec2 optics_limit(vec2 x, float limit)
{
    ivec2 bits = floatBitsToInt(x);
    ivec2 magnitude = min(bits & 0x7fffffff, floatBitsToInt(limit));
    return intBitsToFloat(magnitude | (bits & ~0x7fffffff));
}

vec3 optics_limit(vec3 x, float limit)
{
    ivec3 bits = floatBitsToInt(x);
    ivec3 magnitude = min(bits & 0x7fffffff, floatBitsToInt(limit));
    return intBitsToFloat(magnitude | (bits & ~0x7fffffff));
}

vec4 optics_limit(vec4 x, float limit)
{
    ivec4 bits = floatBitsToInt(x);
    ivec4 magnitude = min(bits & 0x7fffffff, floatBitsToInt(limit));
    return intBitsToFloat(magnitude | (bits & ~0x7fffffff));
}

// x, or 0 for NaN.
float optics_number(float x)
{
    int bits = floatBitsToInt(x);
    return intBitsToFloat((bits & 0x7fffffff) > 0x7f800000 ? 0 : bits);
}

vec2 optics_number(vec2 v)
{
    return vec2(optics_number(v.x), optics_number(v.y));
}

vec3 optics_number(vec3 v)
{
    return vec3(optics_number(v.xy), optics_number(v.z));
}

vec4 optics_number(vec4 v)
{
    return vec4(optics_number(v.xy), optics_number(v.zw));
}

#endif
