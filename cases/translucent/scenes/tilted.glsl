// Flat layers whose translucent one has a normal of another place.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

uniform vec3 normal;

float solid_height(vec2 uv)
{
    return -0.25;
}

float translucent_height(vec2 uv)
{
    return 0.25;
}

vec3 solid_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}

vec3 translucent_normal(vec2 uv)
{
    return normal;
}

vec3 solid_normal_texel(vec2 uv)
{
    return vec3(0.5, 0.5, 1.0);
}

vec3 translucent_normal_texel(vec2 uv)
{
    return vec3(0.5) + 0.5 * vec3(normal.x, -normal.y, normal.z);
}

vec3 solid_color(vec2 uv)
{
    return vec3(1.0);
}

// The direction itself, as a colour.
vec3 environment(vec3 direction)
{
    return vec3(0.5) + 0.5 * direction;
}
