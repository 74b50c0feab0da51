// Forms of the reflected share of unpolarised light, and approximations of it, as their sources
// state them, flaws included. shaders/optics/fresnel.glsl has what is right everywhere;
// shaders/published/optics.glsl has the thesis' own form.
//
// n1 is the index that the light is in, n2 the one behind the interface, cos_i the cosine of the
// angle from the normal, 0 to 1. Errors are measured in binary32 in the domain that is named.
#ifndef ETALON_PUBLISHED_FRESNEL
#define ETALON_PUBLISHED_FRESNEL

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// By the relative index: its square root's argument cancels near the critical angle, its numerators
// where the indices are nearly equal. 1 at total internal reflection; 0 / 0 for equal indices at
// cos_i = 0. Error: 16 ulp from air into indices of 1.33 to 2.42.
// Source: Pharr, Jakob, Humphreys, Physically Based Rendering, 4th edition, section 9.3.5.
float fresnel_dielectric(float n1, float n2, float cos_i)
{
    float eta = n2 / n1;
    float sin2_t = (1.0 - cos_i * cos_i) / (eta * eta);
    if (sin2_t >= 1.0) {
        return 1.0;
    }
    float cos_t = sqrt(1.0 - sin2_t);
    float parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    float perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

// By g = n2 cos_t / n1, which needs no second cosine. 1 at total internal reflection. Error: 24 ulp
// from air into indices of 1.33 to 2.42; g - c cancels where the indices are nearly equal.
// Source: Cook and Torrance, A Reflectance Model for Computer Graphics, 1982.
float fresnel_cook_torrance(float n1, float n2, float cos_i)
{
    float eta = n2 / n1;
    float square = eta * eta + cos_i * cos_i - 1.0;
    if (square < 0.0) {
        return 1.0;
    }
    float g = sqrt(square);
    float amplitude = (g - cos_i) / (g + cos_i);
    float ratio = (cos_i * (g + cos_i) - 1.0) / (cos_i * (g - cos_i) + 1.0);
    return 0.5 * amplitude * amplitude * (1.0 + ratio * ratio);
}

// R at normal incidence.
float schlick_normal_share(float n1, float n2)
{
    float amplitude = (n1 - n2) / (n1 + n2);
    return amplitude * amplitude;
}

// Schlick's approximation with the incident cosine, as it is written down most often. Off by up to
// 0.076 from air into indices of 1.33 to 2.42; from inside it knows no total internal reflection.
// Source: Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994, eq. (24).
float schlick_pow(float n1, float n2, float cos_i)
{
    float normal = schlick_normal_share(n1, n2);
    return normal + (1.0 - normal) * pow(1.0 - cos_i, 5.0);
}

// The same with the fifth power as three products.
float schlick_products(float n1, float n2, float cos_i)
{
    float normal = schlick_normal_share(n1, n2);
    float rest = 1.0 - cos_i;
    float square = rest * rest;
    return normal + (1.0 - normal) * (square * square * rest);
}

// The same with the fifth power fitted by an exponential (a spherical Gaussian): off by up to 0.079
// from air into indices of 1.33 to 2.42.
// Source: Lagarde, Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel, 2012.
float schlick_gaussian(float n1, float n2, float cos_i)
{
    float normal = schlick_normal_share(n1, n2);
    return normal + (1.0 - normal) * exp2((-5.55473 * cos_i - 6.98316) * cos_i);
}

// A fit to water, 1 into 1.333 alone: off by up to 0.0083.
// Source: forwardscattering.org, post 65.
float fresnel_water_fit(float cos_i)
{
    float square = cos_i * cos_i;
    return (1.1040283 * square - 1.6791086 * cos_i + 0.86057293) /
           (9.739124 * square + 3.293334 * cos_i + 0.8676968);
}

// A fit to glass, 1 into 1.5 alone: off by up to 0.0039.
// Source: forwardscattering.org, post 65.
float fresnel_glass_fit(float cos_i)
{
    float square = cos_i * cos_i;
    return (2.4615278 * square - 3.473652 * cos_i + 1.9117112) /
           (13.303401 * square + 7.186081 * cos_i + 1.9189386);
}

#endif
