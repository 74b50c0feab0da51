// Light's maps as textures, with a mean of four at each further level.
uniform sampler2D entered_map;  // irradiance, depth
uniform sampler2D normal_map;   // in light space, 0 where nothing is

bool on_map(vec2 uv)
{
    return uv.x >= 0.0 && uv.x <= 1.0 && uv.y >= 0.0 && uv.y <= 1.0;
}

vec3 map_irradiance(vec2 uv, float level)
{
    return on_map(uv) ? vec3(textureLod(entered_map, uv, level).x) : vec3(0.0);
}

float map_depth(vec2 uv, float level)
{
    return textureLod(entered_map, uv, level).y;
}

vec3 map_normal(vec2 uv, float level)
{
    return textureLod(normal_map, uv, level).xyz;
}
