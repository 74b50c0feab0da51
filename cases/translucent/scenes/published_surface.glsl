// The same surface, as the published functions take it.
#include "published/translucent.glsl"

#ifndef HALF_DISTANCE
#define HALF_DISTANCE 0.25
#endif
#ifndef ABSORB_COLOR
#define ABSORB_COLOR vec3(1.0, 0.5, 0.0)
#endif
#ifndef GLOBAL_AMBIENT
#define GLOBAL_AMBIENT vec3(0.2)
#endif
#ifndef AMBIENT
#define AMBIENT vec3(0.0)
#endif
#ifndef DIFFUSE
#define DIFFUSE vec3(1.0, 0.8, 0.6)
#endif
#ifndef SPECULAR
#define SPECULAR vec3(0.0)
#endif

#ifndef POLYGON
#define POLYGON vec2(0.5)  // where a fragment is whose lamp has a position
#endif

uniform float n1;
uniform float n2;
uniform vec4 lamp;

TranslucentSurface surface()
{
    vec3 to_lamp = lamp.w == 0.0 ? lamp.xyz : vec3((lamp.xy - POLYGON) / 0.1, lamp.z);
    return TranslucentSurface(n1, n2, ABSORB_COLOR, HALF_DISTANCE, 0.05, vec2(0.2, -0.25), 4.0,
                              to_lamp, vec3(1.0, 0.0, 0.0), GLOBAL_AMBIENT, AMBIENT, DIFFUSE,
                              SPECULAR, ivec2(24, 6), ivec2(8, 5), ivec2(16, 5));
}
