// An inclined solid layer; the oracle relief.ramp. The translucent layer is the box's floor.

#ifdef GL_ES
precision highp float;
#endif

uniform vec2 slope;   // box heights per texture
uniform float level;  // z at the texture's origin

float solid_height(vec2 uv)
{
    return level + dot(slope, uv);
}

float translucent_height(vec2 uv)
{
    return -0.5;
}
