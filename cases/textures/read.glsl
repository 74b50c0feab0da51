// What a shader reads of an image, with nothing added: these cases are about the drivers and about
// how the kit hands them its images.
uniform sampler2D map;
uniform samplerCube sky;

vec4 texel(int i, int j, int level)
{
    return texelFetch(map, ivec2(i, j), level);
}

vec4 sample_at(float u, float v, float level)
{
    return textureLod(map, vec2(u, v), level);
}

ivec2 size_of(int level)
{
    return textureSize(map, level);
}

vec4 sky_toward(vec3 direction, float level)
{
    return textureLod(sky, direction, level);
}
