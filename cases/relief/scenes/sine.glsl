// A wave as the solid layer; the oracle relief.sine. The translucent layer is the box's floor.

#ifdef GL_ES
precision highp float;
#endif

uniform float amplitude;  // box heights
uniform vec2 wave;        // waves per texture
uniform float phase;      // waves
uniform float level;      // z

// sin(2 pi turns), within 2e-7 on every device: the specifications let sin() be off by 5e-4, and on
// desktop GL by anything.
float sine_of_turns(float turns)
{
    float part = turns - floor(turns + 0.5);
    part = abs(part) > 0.25 ? sign(part) * 0.5 - part : part;
    float square = part * part;
    float series = 42.00978 + square * -14.393967;
    series = -76.70428 + square * series;
    series = 81.605225 + square * series;
    series = -41.3417 + square * series;
    series = 6.2831855 + square * series;
    return part * series;
}

float solid_height(vec2 uv)
{
    return level + amplitude * sine_of_turns(dot(wave, uv) + phase);
}

float translucent_height(vec2 uv)
{
    return -0.5;
}
