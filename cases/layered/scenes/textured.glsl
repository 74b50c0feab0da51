// A picture and an inner layer from a texture, `map`.

#ifdef GL_ES
precision highp float;
#endif

uniform highp sampler2D map;

vec3 inner_layer(vec2 uv, float level)
{
    return textureLod(map, uv, level).rgb;
}

vec3 picture(vec2 uv)
{
    return textureLod(map, uv, 0.0).rgb;
}
