// Where to look into a cube map of the surroundings.
//
// A cube map shows its surroundings as seen from its centre. From any other place the same
// direction leads elsewhere: the error is about the way from the centre over the distance of what
// is seen. Where that distance is known, the direction can be corrected.
#ifndef ETALON_TRANSLUCENT_ENVIRONMENT
#define ETALON_TRANSLUCENT_ENVIRONMENT

#include "../layered/unit.glsl"

// The unit vector along v, of any length; a NaN counts as 0, a zero vector as (0, 0, 1).
vec3 environment_unit(vec3 v)
{
    return layered_unit(optics_number(v), vec3(0.0, 0.0, 1.0));
}

// The way along unit direction d from p, inside, to the wall at half_size or -half_size.
float environment_wall(float p, float d, float half_size)
{
    float room = d < 0.0 ? p + half_size : half_size - p;
    return room < 1e6 * abs(d) ? max(room, 0.0) / abs(d) : 1e6;
}

// The direction, of unit length, in which a cube map taken at the centre of a room shows what is
// seen from `position` along `direction`. The room is a box around the centre, parallel to the
// axes; position and half_size are relative to that centre and in one unit. A position outside
// counts as the nearest inside; half sizes count as 1e-3..1e4, so that no input yields NaN or
// infinity. Error: 1e-6 per component, and 4e-7 |half_size| over the distance from the centre of
// the point seen.
// Source: exact for what thesis 3.3.1 describes as the flaw of cube maps.
vec3 environment_direction_in_box(vec3 position, vec3 direction, vec3 half_size)
{
    vec3 size = optics_limit(optics_number(half_size), 1e-3, 1e4);
    vec3 p = clamp(optics_limit(optics_number(position), 1e4), -size, size);
    vec3 d = environment_unit(direction);
    float way = min(environment_wall(p.x, d.x, size.x),
                    min(environment_wall(p.y, d.y, size.y), environment_wall(p.z, d.z, size.z)));
    return environment_unit(p + way * d);
}

// The same for surroundings at one distance from the centre, a sphere of that radius, 1e-3..1e4.
// Error: 1e-6 per component, over the cosine at which the ray meets the sphere: near it, along it,
// a position's square has lost the distance to it in its rounding, and the error is up to 5e-4.
vec3 environment_direction_in_sphere(vec3 position, vec3 direction, float radius)
{
    float r = optics_limit(optics_number(radius), 1e-3, 1e4);
    vec3 p = optics_limit(optics_number(position), 1e4) / r;
    float p_p = dot(p, p);
    if (p_p > 1.0) {
        p *= inversesqrt(p_p);
        p_p = 1.0;
    }
    vec3 d = environment_unit(direction);
    float b = dot(p, d);
    float root = sqrt(max(b * b + (1.0 - p_p), 0.0));
    // Of -b + root and its conjugate, the one without cancellation.
    float way = b > 0.0 ? (1.0 - p_p) / max(b + root, 1e-30) : root - b;
    return environment_unit(p + way * d);
}

#endif
