// The light that enters a surface, for a light's map.
#ifndef ETALON_SHADOW_MAP_IRRADIANCE
#define ETALON_SHADOW_MAP_IRRADIANCE

#include "../optics/fresnel.glsl"
#include "light_space.glsl"

// From the surface to the light, of unit length; (0, 0, 1) where the two coincide.
// Source: blog part one, listing 2, where it points the other way.
vec3 light_direction(vec3 position, vec3 light_position)
{
    return light_unit(light_position - position, vec3(0.0, 0.0, 1.0));
}

// The share of the light that enters a medium of index refr_index from the air, by Fresnel's
// equations: 16 ulp. Grazing light, and light from behind, does not enter: 0.
float light_transmission(float refr_index, float n_dot_l)
{
    return fresnel_transmittance(1.0, light_limit(refr_index, 1.0 / 1024.0, 1024.0),
                                 light_limit(n_dot_l, 0.0, 1.0));
}

// The same by Schlick's approximation, (1 - F0) (1 - (1 - cos)^5): 0 at grazing, 1 - F0 at normal
// incidence, and off by up to 0.0757 for indices of 1.3 to 2.42. For indices above one.
// Source: blog part one, listing 2, whose Ft rises instead.
float light_transmission_schlick(float refr_index, float n_dot_l)
{
    float n = light_limit(refr_index, 1.0, 1024.0);
    float amplitude = (n - 1.0) / (n + 1.0);
    float rest = 1.0 - light_limit(n_dot_l, 0.0, 1.0);
    float rest_squared = rest * rest;
    return (1.0 - amplitude * amplitude) * (1.0 - rest_squared * rest_squared * rest);
}

// The irradiance that enters, per channel. normal and to_light may have any length; intensity is
// the light's irradiance on a surface across it, albedo the surface's colour; both are limited to
// 0..1e18. 0 for light from behind. Error: 1e-6 relative beside that of the cosine, 2e-7 absolute.
vec3 light_irradiance(vec3 normal, vec3 to_light, float refr_index, vec3 intensity, vec3 albedo)
{
    float cosine = dot(light_unit(normal, vec3(0.0)), light_unit(to_light, vec3(0.0)));
    cosine = clamp(cosine, 0.0, 1.0);
    return light_transmission(refr_index, cosine) * cosine * light_limit(intensity, 0.0, 1e18)
        * light_limit(albedo, 0.0, 1e18);
}

#endif
