// A plane out of which a sphere rises; the oracle relief.sphere_cap. The sphere's centre lies on the
// box's floor. The translucent layer is the box's floor.

#ifdef GL_ES
precision highp float;
#endif

uniform vec2 centre;               // texture coordinates
uniform float radius;              // box heights
uniform float level;               // z of the plane
uniform float texture_per_height;  // texture coordinates per box height

float solid_height(vec2 uv)
{
    vec2 way = (uv - centre) / texture_per_height;
    float square = radius * radius - dot(way, way);
    return max(level, square > 0.0 ? sqrt(square) - 0.5 : -0.5);
}

float translucent_height(vec2 uv)
{
    return -0.5;
}
