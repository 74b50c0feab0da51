// Snell's law in angles, for what is drawn or typed in them; light itself is computed in cosines.
//
// Angles are in radians from the normal, 0 to pi/2; angles outside are limited to that. n1, n2 and
// their clamping: snell.glsl. The sine and the arcsine are made here, as no specification bounds
// those of a driver better than 2^-11 and 4096 ulp; Mesa's asin errs by 4e-4.
#ifndef ETALON_OPTICS_ANGLE
#define ETALON_OPTICS_ANGLE

#include "snell.glsl"

const float OPTICS_HALF_PI = 1.57079632679;

// The index of refraction, the speed of light in vacuum over that in the medium; both in one unit,
// 2^-60 to 2^60 of it. Limited to [1/1024, 1024]; below 1 where the phase outruns the vacuum's
// light. It is no optical density: that word names the logarithm of what a medium absorbs.
// Error: that of one division.
// Source: thesis eq. (5).
float index_of_refraction(float vacuum_speed, float speed)
{
    const float fastest = 1152921504606846976.0;
    return optics_clamp_index(optics_limit(vacuum_speed, 1.0 / fastest, fastest) /
                              optics_limit(speed, 1.0 / fastest, fastest));
}

// sin(angle) for 0 .. pi/2, within 3 ulp.
float optics_sine(float angle)
{
    float z = angle * angle;
    float rest = -0.1666666662 +
                 z * (0.008333330974 +
                      z * (-0.0001984086118 + z * (2.752526981e-06 - z * 2.38892177e-08)));
    return min(angle + angle * (z * rest), 1.0);
}

// arcsin(x) for 0 .. 1, where below = 1 - x is known better than x is; within 4 ulp.
float optics_arcsine(float x, float below)
{
    bool steep = x > 0.5;
    float y = steep ? sqrt(0.5 * below) : x;
    float z = y * y;
    float rest =
        0.1666665764 +
        z * (0.07500571381 +
             z * (0.04450870951 + z * (0.0318571888 + z * (0.01429525639 + z * 0.03767713786))));
    float angle = y + y * (z * rest);
    return steep ? OPTICS_HALF_PI - 2.0 * angle : angle;
}

// The angle of incidence beyond which all light is reflected, arcsin(n2 / n1); pi/2 where
// n1 <= n2, for no angle is beyond it. Error: 4 ulp. Costs up to 3 times the published form, whose
// arcsine is a driver's.
// Source: thesis eq. (8).
float critical_angle(float n1, float n2)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    return n1 > n2 ? optics_arcsine(n2 / n1, (n1 - n2) / n1) : OPTICS_HALF_PI;
}

// The angle between the refracted ray and the normal; the given one for equal indices; pi/2, the
// surface itself, at the critical angle and beyond: total_internal_reflection says whether there is
// a ray. Error: 8 ulp where cos_t > 0.1; as the angle's own rounding counts for 1 / cos_t, 4e-4
// about the critical angle. Costs 1.4 to 2.5 times the published form, whose sine and arcsine are a
// driver's.
// Source: thesis eqs. (6), (7); an angle from the normal is pi/2 there, not the 0 of (7).
float refracted_angle(float n1, float n2, float angle)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    angle = optics_limit(angle, 0.0, OPTICS_HALF_PI);
    if (n1 == n2) {
        return angle;
    }
    float sine = n1 / n2 * optics_sine(angle);
    return sine < 1.0 ? optics_arcsine(sine, 1.0 - sine) : OPTICS_HALF_PI;
}

#endif
