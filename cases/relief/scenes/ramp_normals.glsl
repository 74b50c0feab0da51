// The normals of ramp.glsl at 0.1 texture coordinates to the box height, in isotropic units.
vec3 solid_normal(vec2 uv)
{
    return normalize(vec3(-0.1 * slope, 1.0));
}

vec3 translucent_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}
