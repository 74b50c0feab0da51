// Terraces along u with vertical walls between them; the oracle relief.steps. The translucent layer
// is the box's floor.

#ifdef GL_ES
precision highp float;
#endif

uniform float width;  // texture coordinates
uniform float rise;   // box heights, of every second terrace
uniform float level;  // z of the others

float solid_height(vec2 uv)
{
    return level + rise * mod(floor(uv.x / width), 2.0);
}

float translucent_height(vec2 uv)
{
    return -0.5;
}
