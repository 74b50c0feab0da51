// A flat solid layer and a translucent wall on it: of height wall_top, from x = wall_start on, so
// wide.
uniform float wall_start;
uniform float wall_width;
uniform float wall_top;
uniform float solid_level;

float solid_height(vec2 uv)
{
    return solid_level;
}

float translucent_height(vec2 uv)
{
    return uv.x >= wall_start && uv.x <= wall_start + wall_width ? wall_top : -0.5;
}
