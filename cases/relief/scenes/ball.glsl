// How far a point on the ball around a position, of the radius that the distance map holds there,
// is above the surface, in box heights; no less than 0 if the map keeps its promise. Positions in
// the solid do not count. At 0.1 texture coordinates to the box height.
float ball_above_surface(vec2 uv, float z, vec3 direction)
{
    float radius = max(distance_at(vec3(uv, z)), 0.0);
    vec2 touched = uv + 0.1 * radius * direction.xy;
    float above = z + radius * direction.z - solid_height(touched);
    return z > solid_height(uv) ? above : 0.0;
}
