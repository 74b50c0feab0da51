// The cones of cone_map, bilinear; beside texels.glsl.
uniform highp sampler2D cone_map;

float cone_at(vec2 uv)
{
    return texel_height(cone_map, uv);
}
