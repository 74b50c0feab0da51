// The depth of a relief's point, so that reliefs and other surfaces hide each other where they
// should (to be written to gl_FragDepth).
//
// A perspective projection has clip z = a * z + b and w = -z of a point's eye-space z: a is element
// [2][2] of its matrix, b is [3][2].
#ifndef ETALON_RELIEF_DEPTH
#define ETALON_RELIEF_DEPTH

#include "ray.glsl"

// The depth 0 .. 1 of a point so far in front of the eye (-z, a length), for clip volumes with z of
// -w .. w (OpenGL). Nearer than the near plane, behind the eye, or NaN: 0; beyond the far plane: 1.
// Error 2.4e-7 for terms and distances that are exact.
float window_depth(float a, float b, float eye_distance)
{
    float depth = 0.5 * (b / eye_distance - a) + 0.5;
    return eye_distance > 0.0 && depth > 0.0 ? min(depth, 1.0) : 0.0;
}

// The same for clip volumes with z of 0 .. w (Vulkan, Direct3D). With reversed depth 1 is near.
float window_depth_from_zero(float a, float b, float eye_distance)
{
    float depth = b / eye_distance - a;
    return eye_distance > 0.0 && depth > 0.0 ? min(depth, 1.0) : 0.0;
}

// How far in front of the eye a hit is: the polygon's point, in the middle of the box, is there at
// eye_distance, and the ray goes on from it by (t - its way there) box heights, of which each takes
// it forward_per_height away from the eye: the box's height times the cosine between ray and view
// axis. Rays that do not fall have no point of the polygon; for them, for a miss and for lengths
// that are no numbers it is eye_distance.
float relief_eye_distance(ReliefRay ray, ReliefHit hit, float eye_distance,
                          float forward_per_height)
{
    float fall = -ray.velocity.z;
    float to_polygon = ray.start.z / fall;
    float distance = eye_distance + (hit.t - to_polygon) * forward_per_height;
    bool usable = hit.layer != RELIEF_NONE && fall > 0.0 && abs(distance) <= 3.0e38;
    return usable ? distance : eye_distance;
}

// The depth of a hit.
float relief_depth(ReliefRay ray, ReliefHit hit, float a, float b, float eye_distance,
                   float forward_per_height)
{
    return window_depth(a, b, relief_eye_distance(ray, hit, eye_distance, forward_per_height));
}

#endif
