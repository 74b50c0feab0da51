// The relief search of V. Timonen, "Real-time visual simulation of volumetric surfaces"
// (2006), as published: the mathematics of chapters 1.3.2, 2.1, 2.2 and 4.1.1 and of the fragment
// shader (appendix A.2), flaws included. What the shader reads from globals are parameters here:
// eye (its direction to the eye, in tangent space, of any length), uv (the polygon fragment's
// texture coordinates) and relative_height (half the box's height in texture coordinates, 0.05).
//
// The scene gives the heights already decoded, z = scale * sample + level in the box -0.5 .. 0.5.
// Points are vec3(texture coordinates, z). An encounter is 1 for the translucent layer, 2 for the
// solid one, 0 for both within one step.
#ifndef ETALON_PUBLISHED_RELIEF
#define ETALON_PUBLISHED_RELIEF

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

float solid_height(vec2 uv);
float translucent_height(vec2 uv);

// Height decode: the text has samples of -1 .. 1, the shader takes 0 .. 1.
float decode_height(float height_sample, float scale, float level)
{
    return height_sample * scale + level;
}

// Offset mapping (1.3.2, figure 10): one height sample, taken where the ray meets the polygon.
vec2 offset_mapping(vec2 uv, vec3 eye, float relative_height)
{
    float height = solid_height(uv);
    return uv + height * 2.0 * relative_height * eye.xy / eye.z;
}

// The same with the offset limited (Welsh): not divided by eye.z.
vec2 offset_mapping_limited(vec2 uv, vec3 eye, float relative_height)
{
    float height = solid_height(uv);
    return uv + height * 2.0 * relative_height * eye.xy;
}

// One secant step. Infinite or NaN where the gaps at both ends are alike.
vec3 linearly_approximate(vec3 range1, vec3 range2, vec2 heights)
{
    return range1 + (range2 - range1) * ((range1.z - heights.x) /
                                         (heights.y - heights.x - range2.z + range1.z));
}

// The search's first point, above the fragment in the box's top, and its step for one of `steps`.
vec3 search_start(vec3 eye, float relative_height)
{
    return vec3(eye.x / eye.z * relative_height, eye.y / eye.z * relative_height, 0.5);
}

vec3 search_step(vec3 eye, float relative_height, int steps)
{
    return -search_start(eye, relative_height) / float(steps) * 2.0;
}

// The linear search for the first encounter. Endless where no height is ever above the ray.
int search_intersection(out vec3 range1, out vec3 range2, int steps, vec3 eye, vec2 uv,
                        float relative_height)
{
    vec3 way = search_step(eye, relative_height, steps);
    range2 = search_start(eye, relative_height) + way;
    range2.xy += uv;
    int encounter = 0;
    while (true) {
        float solid = solid_height(range2.xy);
        float translucent = translucent_height(range2.xy);
        if (solid > range2.z) {
            encounter = translucent > range2.z ? 0 : 2;
            break;
        }
        if (translucent > range2.z) {
            encounter = 1;
            break;
        }
        range2 += way;
    }
    range1 = range2 - way;
    return encounter;
}

// Bisection of that bracket: on both layers until one is known to be first, then on that one.
// heights are those of the encountered layer at the two ends.
int refine_range(inout vec3 range1, inout vec3 range2, out vec2 heights, int iterations,
                 int encounter)
{
    int i = 0;
    for (; encounter == 0 && i < iterations; ++i) {
        vec3 middle = (range1 + range2) * 0.5;
        float solid = solid_height(middle.xy);
        float translucent = translucent_height(middle.xy);
        if (solid > middle.z) {
            range2 = middle;
            if (translucent < middle.z) {
                encounter = 2;
            }
        } else if (translucent < middle.z) {
            range1 = middle;
        } else {
            encounter = 1;
            range2 = middle;
        }
    }
    if (encounter == 0) {
        encounter = 2;
    }
    for (; i < iterations; ++i) {
        vec3 middle = (range1 + range2) * 0.5;
        float height = encounter == 1 ? translucent_height(middle.xy) : solid_height(middle.xy);
        if (height < middle.z) {
            range1 = middle;
        } else {
            range2 = middle;
        }
    }
    if (encounter == 1) {
        heights = vec2(translucent_height(range1.xy), translucent_height(range2.xy));
    } else {
        heights = vec2(solid_height(range1.xy), solid_height(range2.xy));
    }
    return encounter;
}

// The translucent layer's crossing between a point above it and one below: `iterations` bisections
// (5 in the shader) and one secant step.
vec3 refine_tlayer_int(vec3 range1, vec3 range2, int iterations)
{
    vec2 heights = vec2(0.0);
    bool first_sampled = false;
    bool second_sampled = false;
    for (int i = 0; i < iterations; ++i) {
        vec3 middle = (range1 + range2) * 0.5;
        float height = translucent_height(middle.xy);
        if (height < middle.z) {
            range1 = middle;
            heights.x = height;
            first_sampled = true;
        } else {
            range2 = middle;
            heights.y = height;
            second_sampled = true;
        }
    }
    if (!first_sampled) {
        heights.x = translucent_height(range1.xy);
    }
    if (!second_sampled) {
        heights.y = translucent_height(range2.xy);
    }
    return linearly_approximate(range1, range2, heights);
}

// The whole search of the shader's main: linear, binary, secant. The encounter is 1 or 2.
int find_relief(out vec3 point, int steps, int iterations, vec3 eye, vec2 uv,
                float relative_height)
{
    vec3 range1;
    vec3 range2;
    vec2 heights;
    int encounter = search_intersection(range1, range2, steps, eye, uv, relative_height);
    encounter = refine_range(range1, range2, heights, iterations, encounter);
    point = linearly_approximate(range1, range2, heights);
    return encounter;
}

#endif
