// sin(2 pi turns), within 2e-7 on every device: the specifications let sin() be off by 5e-4, and on
// desktop GL by anything.
#ifndef ETALON_SCENE_SINE_OF_TURNS
#define ETALON_SCENE_SINE_OF_TURNS

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

float sine_of_turns(float turns)
{
    float part = turns - floor(turns + 0.5);
    // The nearer of the two places with this sine: -1/4 .. 1/4.
    part = abs(part) > 0.25 ? (part < 0.0 ? -0.5 : 0.5) - part : part;
    float square = part * part;
    float series = 42.00978 + square * -14.393967;
    series = -76.70428 + square * series;
    series = 81.605225 + square * series;
    series = -41.3417 + square * series;
    series = 6.2831855 + square * series;
    return part * series;
}

#endif
