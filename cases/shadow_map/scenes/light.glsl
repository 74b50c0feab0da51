// A light at the origin, looking along -z with an opening of 90 degrees, and what a rasteriser does
// behind the vertex stage.

mat4 light_projection(float near_plane, float far_plane)
{
    float range = near_plane - far_plane;
    return mat4(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0,
                (near_plane + far_plane) / range, -1.0, 0.0, 0.0,
                2.0 * near_plane * far_plane / range, 0.0);
}

// The share of b's varyings at the part t of the way from a to b on the screen.
float varying_weight(vec4 a, vec4 b, float t)
{
    float of_b = t / b.w;
    return of_b / ((1.0 - t) / a.w + of_b);
}

// The depth of the fragment's position after the division by w, in front of the light.
float depth_ndc(float z, float near_plane, float far_plane)
{
    vec4 clip = light_projection(near_plane, far_plane) * vec4(0.0, 0.0, z, 1.0);
    return clip.z / clip.w;
}
