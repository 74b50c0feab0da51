// A wave along u: z + y sin(2 pi x (u + w)), of x waves per texture, amplitude y, level z and phase
// w in textures. Off by 2e-7 of the amplitude, where a driver's own sine may be by 2^-11.
#ifndef ETALON_SCENE_WAVE_HEIGHT
#define ETALON_SCENE_WAVE_HEIGHT

// sin(2 pi turns)
float sine_of_turns(float turns)
{
    float part = turns - floor(turns + 0.5);
    // The nearer of the two places with this sine: -1/4 .. 1/4.
    part = abs(part) > 0.25 ? (part < 0.0 ? -0.5 : 0.5) - part : part;
    float x = 6.283185307 * part;
    float x2 = x * x;
    return x * (1.0 + x2 * (-0.16666667 + x2 * (8.3333333e-3 + x2 * (-1.9841270e-4 +
           x2 * (2.7557319e-6 - x2 * 2.5052108e-8)))));
}

float wave_height(vec4 wave, vec2 uv)
{
    return wave.z + wave.y * sine_of_turns(wave.x * (uv.x + wave.w));
}

#endif
