// The height at uv in a map that holds heights as z: bilinear between the texels' centres,
// repeating, whatever the map's own filter and wrap are, in the arithmetic of a float. A sampler's
// own filter has weights of 8 bits, and softpipe's texelFetch takes the level of a neighbour.
#ifndef ETALON_SCENE_TEXEL_HEIGHT
#define ETALON_SCENE_TEXEL_HEIGHT

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

float texel_height(highp sampler2D map, vec2 uv)
{
    vec2 size = vec2(textureSize(map, 0));
    // floor and fract of uv * size - 0.5, without its rounding.
    vec2 place = uv * size;
    vec2 part = place - floor(place);
    vec2 upper_half = step(0.5, part);
    vec2 cell = floor(place) + upper_half - 1.0;
    vec2 within = (part - upper_half) + 0.5;
    vec2 first = fract((cell + 0.5) / size);
    vec2 second = fract((cell + 1.5) / size);
    float h00 = textureLod(map, first, 0.0).x;
    float h10 = textureLod(map, vec2(second.x, first.y), 0.0).x;
    float h01 = textureLod(map, vec2(first.x, second.y), 0.0).x;
    float h11 = textureLod(map, second, 0.0).x;
    // Not mix(), which makes of two equal heights a different one.
    float lower = h00 + within.x * (h10 - h00);
    float upper = h01 + within.x * (h11 - h01);
    return lower + within.y * (upper - lower);
}

#endif
