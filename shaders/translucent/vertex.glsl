// The vertex stage of a translucent surface.
#ifndef ETALON_TRANSLUCENT_VERTEX
#define ETALON_TRANSLUCENT_VERTEX

#include "../optics/limit.glsl"

// What is interpolated. eye and light are not of unit length: only so are they, between the
// vertices of a flat polygon, those of the place between.
struct TranslucentVertex {
    vec4 position;  // in clip space
    vec2 uv;
    vec3 eye;    // from the vertex to the eye, in tangent space and box heights
    vec4 light;  // to the lamp, likewise, with w = 1; or the direction to it, with w = 0
};

// position, the eye and the lamp (w = 0 for a direction) are in object space; frame has the
// directions of the texture's u and v and the normal as unit columns at right angles, height is a
// box height in object space, at least 1e-6. Takes no built-in variable, and leaves the lights'
// colours to the fragment, as they do not vary. Components count as +-2^40 at most, a NaN as the
// bound on the side of its sign bit, those of the matrix too; no input yields NaN. Error: 4e-7
// of the distances.
// Source: thesis appendix A.1, whose directions the application prepares.
TranslucentVertex translucent_vertex(mat4 object_to_clip, vec3 position, vec2 uv, mat3 frame,
                                     float height, vec3 eye, vec4 lamp)
{
    const float far = 1099511627776.0;
    position = optics_limit(position, far);
    mat3 axes = mat3(optics_limit(frame[0], far), optics_limit(frame[1], far),
                     optics_limit(frame[2], far));
    float per_height = 1.0 / optics_limit(height, 1e-6, far);
    vec3 to_eye = optics_limit(eye, far) - position;
    vec3 to_lamp = optics_limit(lamp.xyz, far) - (lamp.w == 0.0 ? vec3(0.0) : position);
    vec4 clip = vec4(0.0);
    for (int column = 0; column < 4; ++column) {
        float factor = column < 3 ? position[column] : 1.0;
        vec4 entries = object_to_clip[column];
        clip += vec4(optics_limit(entries.xyz, far), optics_limit(entries.w, far)) * factor;
    }
    return TranslucentVertex(clip, optics_limit(uv, far), (to_eye * per_height) * axes,
                             vec4((to_lamp * per_height) * axes, lamp.w == 0.0 ? 0.0 : 1.0));
}

#endif
