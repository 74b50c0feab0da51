// An inclined translucent layer, z = 0.125 + slope * (u - 0.25), over the flat solid z = -0.25.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

uniform float slope;  // box heights per texture; 0.1 textures are a box height

float solid_height(vec2 uv)
{
    return -0.25;
}

float translucent_height(vec2 uv)
{
    return 0.125 + slope * (uv.x - 0.25);
}

vec3 solid_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}

vec3 translucent_normal(vec2 uv)
{
    return vec3(-0.1 * slope, 0.0, 1.0);
}

vec3 solid_color(vec2 uv)
{
    return vec3(1.0);
}

vec3 environment(vec3 direction)
{
    return vec3(0.0);
}
