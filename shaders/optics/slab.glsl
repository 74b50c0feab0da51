// Light that meets a plane-parallel slab of index n2 in a medium of index n1.
//
// cos_i is the cosine outside; thickness is measured across the slab, half_distance the way that
// halves the light, in the same unit (absorption.glsl). Wider than the light is coherent: energies
// add, each polarisation for itself. Nothing leaves the slab beyond its critical angle, which no
// light reaches that came through its face; the rest: snell.glsl. No input yields NaN or infinity.
#ifndef ETALON_OPTICS_SLAB
#define ETALON_OPTICS_SLAB

#include "absorption.glsl"
#include "fresnel.glsl"

// The way across the slab along the refracted ray, thickness / cos_t; thickness 2^12 where that is
// longer. Error: 5 ulp.
float slab_way(float n1, float n2, float cos_i, float thickness)
{
    thickness = optics_limit(thickness, 0.0, 1.0e30);
    return thickness / max(cos_transmitted(n1, n2, cos_i), 1.0 / 4096.0);
}

// (reflected, transmitted) share of one polarisation, for the face's own (reflected, transmitted).
// loss = 1 - left^2 is what the way there and back absorbs.
vec2 optics_slab_shares(float reflected, float transmitted, float left, float loss)
{
    // 1 - (reflected left)^2 as a sum, which does not cancel.
    float remainder = transmitted * (1.0 + reflected) + reflected * reflected * loss;
    if (remainder <= 0.0) {
        return vec2(1.0, 0.0);
    }
    // The first factor is at most 1.
    float inside = transmitted / remainder;
    float through = inside * transmitted * left;
    return vec2(min(reflected + through * reflected * left, 1.0), through);
}

// The shares (reflected, transmitted) of unpolarised light after all re-reflections between the
// faces: T^2 a / (1 - R^2 a^2) and R (1 + a T^2 a / (1 - R^2 a^2)), the mean of both polarisations,
// a the share that one way across leaves. (1, 0) at total internal reflection and, but for equal
// indices, at grazing. Without absorption the two sum to 1 within 4 ulp. Error: 10 ulp or 1e-9,
// with an exp2 within 3 ulp.
// Source: the geometric series over the re-reflections that thesis section 3.2.2 describes.
vec2 slab_shares(float n1, float n2, float cos_i, float thickness, float half_distance)
{
    vec4 face = optics_fresnel(n1, n2, cos_i);
    float way = slab_way(n1, n2, cos_i, thickness);
    float left = transmitted_fraction(way, half_distance);
    float loss = absorbed_fraction(2.0 * way, half_distance);
    return 0.5 * (optics_slab_shares(face.x, face.z, left, loss) +
                  optics_slab_shares(face.y, face.w, left, loss));
}

// The share of unpolarised light that crosses the slab and meets each face once:
// (T_s^2 + T_p^2) / 2 a. Without re-reflections it is the product of the faces, each for its
// polarisation; the product of the mean shares, as if the light were depolarised between them, is
// less by the square of half their difference. Error: 12 + 2 y ulp where the
// way is y half distances, with an exp2 within 3 ulp.
// Source: thesis section 4.2.2, with the polarisations kept apart.
float slab_direct_transmittance(float n1, float n2, float cos_i, float thickness,
                                float half_distance)
{
    vec4 face = optics_fresnel(n1, n2, cos_i);
    return 0.5 * (face.z * face.z + face.w * face.w) *
           transmitted_fraction(slab_way(n1, n2, cos_i, thickness), half_distance);
}

// The product of the two faces' shares as the thesis takes them, of unpolarised light each, with
// the direction refracted in between: what a light ray keeps that enters a flat layer along
// light_dir and leaves it on the other side. normal opposes light_dir. Never total reflection for
// n1 <= n2. Error: as refraction_intensity, twice; 8 ulp for a dot product that needs no rounding.
// Source: thesis section 4.2.2, appendix A.2 get_light_vector, which leaves the direction straight.
float layer_crossing_intensity(vec3 normal, vec3 light_dir, float n1, float n2)
{
    float cos_i = -dot(optics_clamp_vector(light_dir), optics_clamp_vector(normal));
    if (cos_i < -4e-7) {
        return 0.0;
    }
    // Fresnel's shares are the same both ways along a ray; the way back need not be computed, and
    // its cosine, near the critical one, need not be rounded.
    float face = fresnel_transmittance(n1, n2, optics_limit(cos_i, 0.0, 1.0));
    return face * face;
}

#endif
