// Two flat layers.
uniform float solid_level;
uniform float translucent_level;

float solid_height(vec2 uv)
{
    return solid_level;
}

float translucent_height(vec2 uv)
{
    return translucent_level;
}

vec3 solid_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}

vec3 translucent_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}

float step_density(vec2 uv)
{
    return 0.5;
}
