// A map that holds the same, meaningful or not, everywhere.
uniform vec3 texel_value;

vec3 map_irradiance(vec2 uv, float level)
{
    return texel_value;
}

float map_depth(vec2 uv, float level)
{
    return texel_value.y;
}

vec3 map_normal(vec2 uv, float level)
{
    return texel_value.zxy;
}
