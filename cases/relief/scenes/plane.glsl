// A flat solid layer; the oracle relief.plane. The translucent layer is the box's floor.

#ifdef GL_ES
precision highp float;
#endif

uniform float level;  // z

float solid_height(vec2 uv)
{
    return level;
}

float translucent_height(vec2 uv)
{
    return -0.5;
}
