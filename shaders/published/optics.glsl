// The optics of V. Timonen, Simulating and Rendering Translucent Layered Surfaces ("thesis", 2006),
// and of the paper that came of it, as they print it, flaws included; shaders/optics has what is
// right everywhere. Functions of the same name take the same parameters there.
//
// n1 is the index that the light is in, n2 the one behind the interface, cos_i and cos_t the
// cosines of the angles a1 and a3 from the normal, v the unit direction of travel, n a unit normal,
// whose side each function names. Errors are of binary32 in the domain that is named, where the
// method is right; outside it what is returned is the published method's own.
#ifndef ETALON_PUBLISHED_OPTICS
#define ETALON_PUBLISHED_OPTICS

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// Eq. (5): c0 / v, both in one unit. Error: that of one division.
float index_of_refraction(float vacuum_speed, float speed)
{
    return vacuum_speed / speed;
}

// Eq. (6), solved for a3. Undefined beyond the critical angle: the arcsine has no value. Error: of
// the driver's sin and asin, 4e-4 on Mesa, 1.3e-3 on SwiftShader.
float refracted_angle(float n1, float n2, float angle)
{
    return asin(n1 / n2 * sin(angle));
}

// Eq. (8): the angle of incidence from which on no light passes; n1 > n2. Error: the driver's
// asin's, 4e-4 on Mesa.
float critical_angle(float n1, float n2)
{
    return asin(n2 / n1);
}

// Eq. (7): the refracted ray's angle where the incident one is critical. It is pi/2.
float critical_refracted_angle(float n1, float n2)
{
    return 0.0;
}

// Eq. (19). Undefined beyond the critical angle, where the radicand is negative; cancels near it.
// Error: 4 ulp where cos_t > 0.5.
float cos_transmitted(float n1, float n2, float cos_i)
{
    float ratio = n1 / n2;
    return sqrt(1.0 - ratio * ratio * (1.0 - cos_i * cos_i));
}

// Eq. (9), in angles: 0 / 0 where both are 0.
float fresnel_s_angles(float a1, float a3)
{
    float quotient = sin(a3 - a1) / sin(a3 + a1);
    return quotient * quotient;
}

// Eq. (10), in angles: 0 / 0 where both are 0; the denominator diverges at Brewster's angle.
float fresnel_p_angles(float a1, float a3)
{
    float quotient = tan(a3 - a1) / tan(a3 + a1);
    return quotient * quotient;
}

// Eqs. (9)-(11) in angles, with a3 from eq. (6).
float fresnel_reflectance_angles(float n1, float n2, float a1)
{
    float a3 = refracted_angle(n1, n2, a1);
    return 0.5 * (fresnel_s_angles(a1, a3) + fresnel_p_angles(a1, a3));
}

// Eqs. (9), (10) in cosines: (R_s, R_p). The numerators cancel where the indices are nearly equal;
// 0 / 0 for equal indices at cos_i = 0; undefined at total internal reflection.
vec2 fresnel_reflectance_sp(float n1, float n2, float cos_i)
{
    float cos_t = cos_transmitted(n1, n2, cos_i);
    vec2 quotient = vec2((n1 * cos_i - n2 * cos_t) / (n1 * cos_i + n2 * cos_t),
                         (n1 * cos_t - n2 * cos_i) / (n1 * cos_t + n2 * cos_i));
    return quotient * quotient;
}

// Eq. (11). Error: 12 ulp from air into indices of 1.33 to 2.42; 0.7 of itself where the indices
// differ by 2^-22, 1.1e-3 within 1e-6 of the critical cosine of glass.
float fresnel_reflectance(float n1, float n2, float cos_i)
{
    vec2 shares = fresnel_reflectance_sp(n1, n2, cos_i);
    return (shares.x + shares.y) / 2.0;
}

// Eq. (12): 1 - R, which cancels where R is near 1, at grazing angles. Error: 8 ulp where
// cos_i > 0.1, 0.19 of itself at 1e-7, all of it at 1.85e-8.
float fresnel_transmittance(float n1, float n2, float cos_i)
{
    return 1.0 - fresnel_reflectance(n1, n2, cos_i);
}

// Eq. (14). Wrong for a normal on either side: it is even in n, and the length grows to
// sqrt(1 + 8 cos_i^2).
vec3 reflect_ray(vec3 v, vec3 n)
{
    return v + 2.0 * dot(v, n) * n;
}

// Eq. (16), cos_i the positive cosine: right where n opposes v, and v + 2 cos_i n else.
vec3 reflect_ray_cosine(vec3 v, vec3 n, float cos_i)
{
    return v + 2.0 * cos_i * n;
}

// Eq. (17): right where n opposes v. Undefined at total internal reflection. Error in each
// component: 3e-7 where cos_t > 0.3.
vec3 refract_ray_dot(vec3 v, vec3 n, float n1, float n2)
{
    float along = dot(v, n);
    return n1 * (v - n * along) / n2 - n * sqrt(1.0 - n1 * n1 * (1.0 - along * along) / (n2 * n2));
}

// Eq. (18) with eq. (19): right where n is on the side that v points to; cos_i the positive cosine.
vec3 refract_ray_cosine(vec3 v, vec3 n, float n1, float n2, float cos_i)
{
    float ratio = n1 / n2;
    return ratio * v + (cos_transmitted(n1, n2, cos_i) - ratio * cos_i) * n;
}

// Section 3.1.1: eq. (17) with an index for each channel, a column per channel.
mat3 refract_ray_rgb(vec3 v, vec3 n, vec3 n1, vec3 n2)
{
    return mat3(refract_ray_dot(v, n, n1.r, n2.r), refract_ray_dot(v, n, n1.g, n2.g),
                refract_ray_dot(v, n, n1.b, n2.b));
}

// Appendix A.2, compose_transparent: the reflected ray of the eye's ray v at a normal that points
// into the surface. A normal that faces away has its cosine clamped to 0: the ray goes straight on.
vec3 composed_reflection_ray(vec3 v, vec3 inward)
{
    float cos_i = clamp(dot(v, inward), 0.0, 1.0);
    return v - inward * cos_i * 2.0;
}

// The refracted ray there; not of unit length where the cosine was clamped.
vec3 composed_refraction_ray(vec3 v, vec3 inward, float n1, float n2)
{
    float cos_i = clamp(dot(v, inward), 0.0, 1.0);
    float ratio = n1 / n2;
    float cos_t = sqrt(1.0 - ratio * ratio * (1.0 - cos_i * cos_i));
    return v * ratio + inward * (cos_t - ratio * cos_i);
}

// Appendix A.2, refraction_intensity: the share of a light that passes an interface whose normal
// opposes light_dir, here a parameter. Undefined at total internal reflection.
float refraction_intensity(vec3 normal, vec3 light_dir, float n1, float n2)
{
    float ratio = n1 / n2;
    vec2 cosines;
    cosines.x = clamp(dot(-light_dir, normal), 0.0, 1.0);
    cosines.y = sqrt(1.0 - ratio * ratio * (1.0 - cosines.x * cosines.x));
    vec2 amplitudes = vec2(
        (n1 * cosines.x - n2 * cosines.y) / (n1 * cosines.x + n2 * cosines.y),
        (n1 * cosines.y - n2 * cosines.x) / (n1 * cosines.y + n2 * cosines.x));
    amplitudes *= amplitudes;
    return 1.0 - (amplitudes.x + amplitudes.y) * 0.5;
}

// Appendix A.2, get_light_vector, on a flat layer: in and out again, with the light's direction as
// it is outside also for the way out, as if it were the angle inside.
float layer_crossing_intensity(vec3 normal, vec3 light_dir, float n1, float n2)
{
    return refraction_intensity(normal, light_dir, n1, n2) *
           refraction_intensity(normal, light_dir, n2, n1);
}

// Eq. (13): the absorbed share over d, of which half_distance absorbs half. Cancels for short ways.
// Error: 1.3e-7.
float absorbed_fraction(float d, float half_distance)
{
    return 1.0 - pow(0.5, d / half_distance);
}

// Paper eq. (1), which gives eq. (13) as the factor for the light: the share that is lost.
float transmitted_fraction(float d, float half_distance)
{
    return absorbed_fraction(d, half_distance);
}

// Section 4.1.2 and appendix A.2: 1 - k I in each channel.
vec3 hued_transmittance(float d, float half_distance, vec3 absorb_color)
{
    float left = pow(0.5, d / half_distance);
    return vec3(1.0) - absorb_color * (1.0 - left);
}

// Eq. (23). 0 / 0 or infinite where the ray is parallel to the plane.
float plane_ray_parameter(vec3 i, vec3 v, vec3 s, vec3 n)
{
    return dot(s - i, n) / dot(v, n);
}

// Eq. (25). 0 / 0 or infinite where v.z = 0.
float flat_layer_ray_parameter(float h, vec3 i, vec3 v)
{
    return (h - i.z) / v.z;
}

// Section 4.1.3: eq. (25) where v.z < 0, which is taken for a hit; -1 else. A start below the layer
// yields a way back.
float flat_layer_hit(float h, vec3 i, vec3 v)
{
    return v.z < 0.0 ? (h - i.z) / v.z : -1.0;
}

// Eq. (12) as the share of what is seen: no (n2 / n1)^2.
vec3 transmitted_radiance(vec3 radiance, float n1, float n2, float cos_i)
{
    return radiance * fresnel_transmittance(n1, n2, cos_i);
}

// Section 4.2.1, paper algorithm 1: R reflected + T refracted.
vec3 composed_radiance(vec3 reflected, vec3 refracted, float n1, float n2, float cos_i)
{
    float reflectance = fresnel_reflectance(n1, n2, cos_i);
    return refracted * (1.0 - reflectance) + reflected * reflectance;
}

#endif
