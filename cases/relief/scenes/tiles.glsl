// Values from the tiles that `etalon bake` lays out: TileColumns of them to a row of the image.
#ifndef ETALON_SCENE_TILES
#define ETALON_SCENE_TILES

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

float image_texel(highp sampler2D map, ivec2 texel)
{
    return textureLod(map, (vec2(texel) + 0.5) / vec2(textureSize(map, 0)), 0.0).x;
}

ivec2 wrapped(ivec2 texel, ivec2 size)
{
    vec2 turns = floor((vec2(texel) + 0.5) / vec2(size));
    return texel - ivec2(turns) * size;
}

// Bilinear between the texels' centres of a tile, which repeats.
float tile_value(highp sampler2D map, ivec2 size, int tile, vec2 uv)
{
    int columns = textureSize(map, 0).x / size.x;
    ivec2 corner = ivec2(tile - tile / columns * columns, tile / columns) * size;
    vec2 place = fract(uv) * vec2(size) - 0.5;
    ivec2 cell = ivec2(floor(place));
    vec2 part = place - floor(place);
    ivec2 first = wrapped(cell, size);
    ivec2 second = wrapped(cell + 1, size);
    float v00 = image_texel(map, corner + first);
    float v10 = image_texel(map, corner + ivec2(second.x, first.y));
    float v01 = image_texel(map, corner + ivec2(first.x, second.y));
    float v11 = image_texel(map, corner + second);
    float lower = v00 + part.x * (v10 - v00);
    float upper = v01 + part.x * (v11 - v01);
    return lower + part.y * (upper - lower);
}

// Trilinear between the slices of a volume over z = -0.5 .. 0.5, a tile each.
float volume_value(highp sampler2D map, ivec2 size, int slices, vec3 position)
{
    float place = clamp((position.z + 0.5) * float(slices) - 0.5, 0.0, float(slices - 1));
    int lower = min(int(place), slices - 2);
    float below = tile_value(map, size, lower, position.xy);
    float above = tile_value(map, size, lower + 1, position.xy);
    return below + (place - float(lower)) * (above - below);
}

#endif
