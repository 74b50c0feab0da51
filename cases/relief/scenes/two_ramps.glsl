// Two inclined layers, which cross; the oracle relief.first of two relief.ramp.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

#include "fetches.glsl"

uniform vec2 solid_slope;   // box heights per texture
uniform float solid_level;  // z at the texture's origin
uniform vec2 translucent_slope;
uniform float translucent_level;

float solid_height(vec2 uv)
{
    count_fetch();
    return solid_level + dot(solid_slope, uv);
}

float translucent_height(vec2 uv)
{
    count_fetch();
    return translucent_level + dot(translucent_slope, uv);
}
