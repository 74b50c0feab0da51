// Maps that hold one value everywhere, sensible or not.
uniform float map_value;

float distance_at(vec3 position)
{
    return map_value;
}

float cone_at(vec2 uv)
{
    return map_value;
}

float horizon_at(vec2 uv, int bearing)
{
    return bearing == 0 ? map_value : 0.5;
}

float max_height(ivec2 block, int level)
{
    return level > 2 ? 0.5 : map_value;
}

vec4 solid_cell(ivec2 cell)
{
    return vec4(solid_height(vec2(0.0)), map_value, -0.25, 0.125);
}
