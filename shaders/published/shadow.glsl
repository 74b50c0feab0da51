// The relief's own shadows of V. Timonen, "Real-time visual simulation of volumetric surfaces"
// (2006), as published: the mathematics of chapter 2.4, flaws included.
//
// Points are vec3(texture coordinates, z) on the surface, in the box -0.5 .. 0.5. `light` points to
// the light, in tangent space, and has any length: it is the polygon fragment's. relative_height is
// half the box's height in texture coordinates, 0.05. Ways and distances are in box heights. The
// scene gives the height already decoded.
#ifndef ETALON_PUBLISHED_SHADOW
#define ETALON_PUBLISHED_SHADOW

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

float solid_height(vec2 uv);

// The march's step towards the light: one of `steps` of the box's height.
vec3 light_step(vec3 light, float relative_height, int steps)
{
    return vec3(light.xy / light.z * relative_height * 2.0, 1.0) / float(steps);
}

// The light that reaches the point from a light without size: 0 where any sample up to the box's
// top is above the light's ray, else 1 (2.4.1, figure 29).
float hard_shadow(vec3 point, vec3 light, float relative_height, int steps)
{
    vec3 way = light_step(light, relative_height, steps);
    vec3 position = point + way;
    while (position.z < 0.5) {
        if (solid_height(position.xy) > position.z) {
            return 0.0;
        }
        position += way;
    }
    return 1.0;
}

// Equation (1): h is the height of the light's ray over the surface, d the way along the ray.
float blocking_ratio(float h, float d)
{
    return h / d;
}

// Equation (3): how far from the light's middle the ray passes that touches the surface there, for
// a light at the distance l.
float width_at_light(float ratio, float l)
{
    return ratio * l;
}

// Equation (4), clipped as the text has it: the share of a light of radius r that is seen.
float soft_amount(float ratio, float l, float r)
{
    return clamp(ratio * l / r + 0.5, 0.0, 1.0);
}

// The smallest ratio of the march (2.4.2).
float least_blocking_ratio(vec3 point, vec3 light, float relative_height, int steps)
{
    vec3 way = light_step(light, relative_height, steps);
    float length_of_step = length(light) / light.z / float(steps);
    vec3 position = point + way;
    float d = length_of_step;
    float least = blocking_ratio(position.z - solid_height(position.xy), d);
    position += way;
    while (position.z < 0.5) {
        d += length_of_step;
        least = min(least, blocking_ratio(position.z - solid_height(position.xy), d));
        position += way;
    }
    return least;
}

// The share of the light that reaches the point.
float soft_shadow(vec3 point, vec3 light, float l, float r, float relative_height, int steps)
{
    return soft_amount(least_blocking_ratio(point, light, relative_height, steps), l, r);
}

#endif
