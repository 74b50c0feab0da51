// How the light to the eye, for each of the lamp's on the surface, differs where the eye and the
// lamp change places. One call in a loop: programs of two take twice the time.
#include "translucent/compose.glsl"

TranslucentSurface surface();

vec3 change_by_exchange(vec3 eye, vec3 to_lamp, float level)
{
    vec3 change = vec3(0.0);
    for (int i = 0; i < 2; ++i) {
        TranslucentSurface lit = surface();
        lit.lamp = vec4(i == 0 ? to_lamp : eye, 0.0);
        change = compose_transparent(vec3(0.5, 0.5, level), i == 0 ? eye : to_lamp,
                                     lit) / lit.lamp.z - change;
    }
    return change;
}
