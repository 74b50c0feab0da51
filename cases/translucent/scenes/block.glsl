// Beyond an edge, where uv.x >= edge, both layers are higher, with a wall between; the normals of
// the translucent layer are those of a slab whose lower face is the wall. Not a surface that there
// is, but a slab in a height map: light meets two parallel faces.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

uniform float edge;               // texture coordinate
uniform float solid_level;        // z before the edge; the translucent layer is below it
uniform float solid_block;        // z beyond the edge
uniform float translucent_block;  // z beyond the edge

float solid_height(vec2 uv)
{
    return uv.x < edge ? solid_level : solid_block;
}

float translucent_height(vec2 uv)
{
    return uv.x < edge ? -0.5 : translucent_block;
}

vec3 solid_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}

vec3 translucent_normal(vec2 uv)
{
    return vec3(0.0, 0.0, uv.x < edge + 0.004 ? -1.0 : 1.0);
}

vec3 solid_normal_texel(vec2 uv)
{
    return vec3(0.5, 0.5, 1.0);
}

vec3 translucent_normal_texel(vec2 uv)
{
    return vec3(0.5, 0.5, uv.x < edge + 0.004 ? 0.0 : 1.0);
}

vec3 solid_color(vec2 uv)
{
    return vec3(1.0);
}

vec3 environment(vec3 direction)
{
    return vec3(0.0);
}
