// What a stored depth stands for: the range of depths between the neighbours of a 32-bit float.
float light_depth(float z_light, float near_plane, float far_plane);
float light_depth_way(float depth, float near_plane, float far_plane);

float kept_step(float z, float near_plane, float far_plane)
{
    float depth = light_depth(z, near_plane, far_plane);
    return light_depth_way(depth + 2.0e-7, near_plane, far_plane)
        - light_depth_way(depth - 2.0e-7, near_plane, far_plane);
}
