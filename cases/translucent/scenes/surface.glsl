// A surface of these optics; what is a macro here a case may define otherwise.
#include "translucent/material.glsl"

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
#ifndef EXTENT
#define EXTENT vec4(-65536.0, -65536.0, 65536.0, 65536.0)
#endif
#ifndef LIGHT_WAY
#define LIGHT_WAY TRANSLUCENT_LIGHT_REFRACTED
#endif
#ifndef MIRROR
#define MIRROR TRANSLUCENT_MIRROR_PLANE
#endif
#ifndef PLANE
#define PLANE -0.15
#endif
#ifndef FRAME
#define FRAME mat3(1.0)
#endif
#ifndef VIEW_SEARCH
#define VIEW_SEARCH ivec2(24, 6)
#endif
#ifndef REFRACTION_SEARCH
#define REFRACTION_SEARCH ivec2(8, 5)
#endif
#ifndef LIGHT_SEARCH
#define LIGHT_SEARCH ivec2(16, 5)
#endif

uniform float n1;
uniform float n2;
uniform vec4 lamp;

TranslucentSurface surface()
{
    return TranslucentSurface(n1, n2, ABSORB_COLOR, HALF_DISTANCE, 0.1, EXTENT, lamp,
                              vec3(1.0, 0.0, 0.0), GLOBAL_AMBIENT, AMBIENT, DIFFUSE, SPECULAR,
                              400.0, 10.0, LIGHT_WAY, MIRROR, PLANE, FRAME, VIEW_SEARCH,
                              REFRACTION_SEARCH, LIGHT_SEARCH);
}
