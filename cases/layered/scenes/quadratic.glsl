// An inner layer of the squares and the product of the texture coordinates, in texels of level 0. A
// mip level shows on average what its box and bilinear filters make of a parabola.
vec3 inner_layer(vec2 uv, float level)
{
    float texel = exp2(level);
    float widened = (texel * texel - 1.0) / 4.0;
    return vec3(uv * uv + widened, uv.x * uv.y);
}
