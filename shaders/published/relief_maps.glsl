// The search on a distance map of V. Timonen, "Real-time visual simulation of volumetric surfaces"
// (2006), chapter 2.3.2 (after Donnelly), as published: every hop is as long as the map's distance,
// which is said to skip no intersection.
#ifndef ETALON_PUBLISHED_RELIEF_MAPS
#define ETALON_PUBLISHED_RELIEF_MAPS

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// From the map, in the unit in which `direction` is one long.
float distance_at(vec3 position);

// The point after so many hops, or where the distance is below the threshold.
vec3 trace_distance_map(vec3 point, vec3 direction, float threshold, int iterations)
{
    for (int i = 0; i < iterations; ++i) {
        float distance_to_surface = distance_at(point);
        if (distance_to_surface < threshold) {
            break;
        }
        point += distance_to_surface * direction;
    }
    return point;
}

#endif
