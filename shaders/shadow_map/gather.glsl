// Translucency from a light's map: the light that entered everywhere and leaves at one point.
//
// A map has texel (u, v) stand for the surface point at the lateral place (uv - 0.5) * width and at
// the depth along the light's axis that it keeps, width = extent + spread * depth: spread 0 for a
// parallel light, extent 0 for one at a point. Lengths are in the scene's unit.
//
// The scene gives the map at a level of detail (0 the finest, a level more for twice the texel):
// the irradiance that entered, the depth, and the normal in light space (z to the light). Where the
// map shows no surface, or ends, irradiance and normal are 0, so that a mean over an outline keeps
// the shares right; the depth there should go on as at the outline. What is no number counts as 0.
#ifndef ETALON_SHADOW_MAP_GATHER
#define ETALON_SHADOW_MAP_GATHER

#include "dipole.glsl"

vec3 map_irradiance(vec2 uv, float level);
float map_depth(vec2 uv, float level);
vec3 map_normal(vec2 uv, float level);

struct LightMap {
    float extent;      // the map's width at depth 0, 0..2^20
    float spread;      // what the width gains per unit of depth, 0..1024
    float resolution;  // texels across it, 1..65536
    float reach;       // the widest lateral way between points of the object, 2^-20..2^20
};

const int GATHER_MAX_TAPS = 49;

float gather_width(LightMap map, float depth)
{
    return max(map.extent + map.spread * depth, 1.0 / 1048576.0);
}

float gather_depth(vec2 uv, float level)
{
    return light_limit(map_depth(uv, level), 0.0, 1048576.0);
}

// The surface that a texel sees, per area of the map scaled to its depth: 1 across the light, and
// at most 64, for a surface seen edge-on.
float gather_slant(LightMap map, vec2 uv, vec3 normal)
{
    vec3 to_light = normalize(vec3((0.5 - uv) * map.spread, 1.0));
    float cosine = dot(light_unit(normal, vec3(0.0, 0.0, 1.0)), to_light);
    return to_light.z / max(cosine, to_light.z / 64.0);
}

// The level to read for a share of the map: texels of a half of its area.
float gather_level(float area, float texel)
{
    return max(0.5 * log2(max(area, 1e-18) / (2.0 * texel * texel)), 0.0);
}

// One tap: the light of a part of the map, from its place, depth and normal at that level, weighted
// by the integral of R_d from `inner` to `outer` (squared lateral ways) at the tap's own depth.
// `unit` is the map's width at the depth for which these ways hold.
vec3 gather_tap(LightMap map, Dipole medium, vec3 leaves, float unit, vec2 uv, float level,
                float middle, float inner, float outer)
{
    float depth = gather_depth(uv, level);
    float width = gather_width(map, depth);
    vec3 way = vec3((uv - 0.5) * width, depth) - leaves;
    float height = max(dot(way, way) - middle, 0.0);
    vec3 weight =
        dipole_beyond(medium, inner + height) - dipole_beyond(medium, outer + height);
    float scale = width / unit;
    vec3 entered = light_limit(map_irradiance(uv, level), 0.0, 1e18);
    float surface = scale * scale * gather_slant(map, uv, map_normal(uv, level));
    return entered * (max(weight, 0.0) * surface);
}

// The radiosity that leaves at map coordinate uv and that depth: the sum over the map of irradiance
// times R_d times surface, as far as map.reach. `taps` is 1 + 4 k, at most 49: the disc about uv
// and k rings of four taps each, turned against each other. The rings share the light of an even,
// flat map evenly among the taps, so that they lie close where R_d is steep. A tap reads a level
// half a step finer than its share of the map, and its weight is an integral: an even, flat map is
// gathered exactly by any number of taps. All inputs yield finite results.
// Error against the sum over all 128 x 128 texels. Well inside an outline, in even light, at most
// (and in the mean), for plates level, tilted and in a wedge, 0.25 to 16 mean free paths thick, and
// for a sphere, 0.7 to 8:
//   taps      1            5            13           21           49
//   plates    76 % (26)    22 % (5.3)   7.8 % (2.6)  6.9 % (1.7)  6.7 % (1.5)
//   sphere    51 %         18 %         16 %         16 %         8 %
// Out to the outline it is more, worst for points that see most of their light from beyond it. For
// sigma_a = sigma_s / 20, tilted plates 0.5 to 8 mean free paths thick and a sphere with a radius
// of 2 to 6, on the side away from the light and on the lit one, the worst seen:
//   plates    100 %        31 %         20 %         21 %         21 %
//   away      36 %         85 %         56 %         40 %         33 %
//   lit       100 %        80 %         41 %         26 %         22 %
// So more taps cure little there: the coarse levels blur outlines, and a surface that the map sees
// edge-on, which may be near, has few texels. Uneven light is gathered as by its mean over a tap's
// part: where it swings between 0 and 1 in waves of 8 mean free paths, half of one deep in a
// plate, up to 110, 70, 21, 14 and 3.3 % were seen in the dark parts (not held by a case).
// Cost: four exponentials for each channel of a tap. Point weights, R_d times the area, need two;
// 21 such taps are as good on plates up to one mean free path thick, and up to 12 %, 42 % and
// 320 % off where the thickness is two, four and eight.
// Source: C. Dachsbacher and M. Stamminger, Translucent Shadow Maps, 2003: 21 taps, finer levels
// inside; there with point weights.
vec3 gather_translucency(LightMap map, Dipole medium, vec2 uv, float depth, int taps)
{
    map.extent = light_limit(map.extent, 0.0, 1048576.0);
    map.spread = light_limit(map.spread, 0.0, 1024.0);
    map.resolution = light_limit(map.resolution, 1.0, 65536.0);
    map.reach = light_limit(map.reach, 1.0 / 1048576.0, 1048576.0);
    uv = vec2(light_limit(uv.x, 0.0, 1.0), light_limit(uv.y, 0.0, 1.0));
    depth = light_limit(depth, 0.0, 1048576.0);
    int rings = (clamp(taps, 1, GATHER_MAX_TAPS) - 1) / 4;

    vec3 leaves = vec3((uv - 0.5) * gather_width(map, depth), depth);
    float enters = gather_depth(uv, 0.0);
    float unit = gather_width(map, enters);
    float texel = unit / map.resolution;
    // Nearest is what lies under the point along the axis, not along a slanted ray of the light.
    if (map.spread > 0.0) {
        uv = leaves.xy / unit + 0.5;
    }
    // The light of an even map fades with the way d about as exp(-s d) / d, of which the power in
    // `nearest * left^-power` keeps the slope at the nearest point; `left` is what lies beyond.
    float thickness = depth - enters;
    float pole = dot(medium.real_depth, vec3(1.0 / 3.0));
    float nearest = thickness * thickness + pole * pole;
    float power = 2.0 / (1.0 + dot(medium.extinction, vec3(1.0 / 3.0)) * sqrt(nearest));
    float end = map.reach * map.reach;
    float share = (1.0 - exp2(-log2(1.0 + end / nearest) / power)) / float(1 + 4 * rings);

    float left = 1.0 - share;
    float outer = rings > 0 ? nearest * (exp2(-power * log2(left)) - 1.0) : end;
    float level = gather_level(3.14159265 * outer, texel);
    vec3 sum = gather_tap(map, medium, leaves, unit, uv, level, 0.0, 0.0, outer);
    vec2 axis = vec2(1.0, 0.0);
    for (int ring = 1; ring <= rings; ++ring) {
        float inner = outer;
        float middle = nearest * (exp2(-power * log2(left - 2.0 * share)) - 1.0);
        left -= 4.0 * share;
        outer = ring < rings ? nearest * (exp2(-power * log2(left)) - 1.0) : end;
        level = gather_level(0.78539816 * (outer - inner), texel);
        // By the golden angle, so that no two rings are aligned.
        axis = vec2(-0.73736888 * axis.x - 0.67549029 * axis.y,
                    0.67549029 * axis.x - 0.73736888 * axis.y);
        vec2 offset = sqrt(middle) / unit * axis;
        for (int quarter = 0; quarter < 4; ++quarter) {
            sum += 0.25
                * gather_tap(map, medium, leaves, unit, uv + offset, level, middle, inner, outer);
            offset = vec2(-offset.y, offset.x);
        }
    }
    return sum;
}

#endif
