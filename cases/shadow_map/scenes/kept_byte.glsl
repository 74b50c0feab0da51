// What a stored depth stands for: the range of depths that round to the same of 256 values.
#include "light.glsl"

float depth_code(float z_ndc);

float coded_way(float code, float near_plane, float far_plane)
{
    float range = far_plane - near_plane;
    return near_plane * far_plane / (far_plane - code * range);
}

float kept_step(float z, float near_plane, float far_plane)
{
    float code = depth_code(depth_ndc(z, near_plane, far_plane));
    return coded_way(code + 0.5 / 255.0, near_plane, far_plane)
        - coded_way(code - 0.5 / 255.0, near_plane, far_plane);
}
