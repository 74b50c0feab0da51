// An inner layer of a wave, `wave` in radians per texel; a mip level is the box filter of its texel
// size.
uniform vec2 wave;

float box(float angle)
{
    return abs(angle) < 0.001 ? 1.0 : sin(angle) / angle;
}

vec3 inner_layer(vec2 uv, float level)
{
    float half_texel = level > 0.0 ? 0.5 * exp2(level) : 0.0;
    float left = box(half_texel * wave.x) * box(half_texel * wave.y);
    return vec3(left * cos(dot(wave, uv)), left * sin(dot(wave, uv)), 0.0);
}
