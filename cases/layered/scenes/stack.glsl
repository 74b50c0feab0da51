// Three layers of colour ramps, each with its opacity, thickness of the medium above it and index.
uniform vec3 opacity;
uniform vec3 thickness;
uniform vec3 index;

vec4 stack_layer(int layer, vec2 uv, float level)
{
    return vec4(uv, level, opacity[layer]);
}

vec2 stack_medium(int layer)
{
    return layer < 3 ? vec2(thickness[layer], index[layer]) : vec2(0.0);
}
