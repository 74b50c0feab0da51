// The relief's own shadows: the share of a light that a point of the surface sees, 0 .. 1.
//
// A soft light is a disc, or a square, that faces the point. What hides it is judged in the
// vertical plane through its middle, and taken for an edge that runs straight across it (thesis
// 2.4.2): the light of which a part is hidden is exact for one edge; of several edges the one that
// hides most counts. `t` of the plane's level ray is the way along the surface, in box heights, so
// that a light may stand anywhere, the zenith included; exactly there nothing is in the plane, and
// nothing hides the light.
//
// The box's floor goes on without end: a light below it is dark. No input yields NaN or infinity.
// Several lights are the caller's loop, their light summed.
#ifndef ETALON_RELIEF_SHADOW
#define ETALON_RELIEF_SHADOW

#include "search.glsl"

// A light as the shaded point sees it: the displaced point, not the polygon's. Where the eye looks
// at 60 degrees from the normal, a light 2 box heights over the polygon stands 19 degrees elsewhere
// for a point on the box's floor.
struct ReliefLight {
    vec3 direction;  // to its middle, of any length; zero or NaN: below the point
    float distance;  // in box heights; 1e18 (also for what is no positive number): far away
    float radius;    // in box heights, half the side of a square; negative or NaN: 0, a point
};

// The point is taken this much above where it is said to be: a surface does not hide the light from
// itself because a search found it a little too deep.
const float SHADOW_LIFT = 4e-6;

const float SHADOW_FAR = 1e18;

// The light of this radius at a position, vec3(texture coordinates, z), in or out of the box. What
// is NaN there is taken as 0, coordinates are limited to +-65536, z to +-1e9.
ReliefLight light_at(vec3 position, float radius, vec3 point, float texture_per_height)
{
    vec3 from = vec3(relief_finite(point.x, 65536.0), relief_finite(point.y, 65536.0),
                     relief_finite(point.z, 1.0));
    vec3 to = vec3(relief_finite(position.x, 65536.0), relief_finite(position.y, 65536.0),
                   relief_finite(position.z, 1e9));
    vec3 way = vec3((to.xy - from.xy) / relief_texture_per_height(texture_per_height),
                    to.z - from.z);
    return ReliefLight(way, length(way), radius);
}

float light_distance(ReliefLight light)
{
    return light.distance > 0.0 ? clamp(light.distance, 1e-6, SHADOW_FAR) : SHADOW_FAR;
}

float light_radius(ReliefLight light)
{
    return light.radius > 1e-18 ? min(light.radius, SHADOW_FAR) : 0.0;
}

// The place w on the light's plane in radii: -1 where the light is hidden, 1 where all of it is
// seen. A NaN counts as hidden; of a radius that is zero, negative or NaN all is seen or nothing.
float light_opening(float w, float radius)
{
    float r = radius > 1e-37 ? radius : 0.0;
    return abs(w) < r ? w / r : (w >= 0.0 ? 1.0 : -1.0);
}

// The share of a square light that is seen past an edge along its side at `opening` (-1 .. 1).
// Exact but for one rounding.
float square_light_share(float opening)
{
    return abs(opening) <= 1.0 ? 0.5 * opening + 0.5 : (opening > 0.0 ? 1.0 : 0.0);
}

// The same for a disc: 1 - (acos x - x sqrt(1 - x^2)) / pi. With u = 1 - |x| the hidden share is
// u^1.5 times what is nearly a straight line; a polynomial of degree 5 in its place is off by
// 1.3e-7 at most, at u = 1 (by 2.6e-7 of the share). Within 2.5e-7 in all.
float disc_light_share(float opening)
{
    float u = 1.0 - min(abs(opening), 1.0);
    float series = -1.8760853e-5 + u * -3.8911478e-4;
    series = -1.7823285e-3 + u * series;
    series = -7.9842191e-3 + u * series;
    series = -9.0036415e-2 + u * series;
    series = 0.60021096 + u * series;
    float hidden = abs(opening) < 1.0 ? u * sqrt(u) * series : 0.0;
    return opening >= 0.0 ? 1.0 - hidden : hidden;
}

// The blocking ratio w / l from perpendicular distances: of a place of the surface that lies h
// below the light's ray (above it: negative) after the way d along the ray, where the sine of the
// ray's elevation is `sine`. 1e6, as good as open, for a place that is not before the point, d = 0
// among them; limited to +-1e6. With h / d alone (thesis, equation 1) it is too great by the factor
// (1 - h / d * sine) / cosine: 1.10, 1.31, 1.83, 5.19 at 30, 45, 60, 80 degrees for h / d = 0.1.
float blocking_ratio(float h, float d, float sine)
{
    float height = relief_finite(h, 1e9);
    float s = relief_finite(sine, 1.0);
    float across = height * sqrt((1.0 - s) * (1.0 + s));
    float along = relief_finite(d, 1e9) - height * s;
    return along > 0.0 && abs(across) < 1e6 * along ? across / along
                                                    : (across >= 0.0 ? 1e6 : -1e6);
}

// How far from the light's middle the ray passes that touches the surface there, for a light at the
// distance l.
float width_at_light(float ratio, float l)
{
    return relief_finite(ratio, 1e6) * relief_finite(l, SHADOW_FAR);
}

// The share that equation (4) is to be: of a square light of radius r, half its side.
float soft_amount(float ratio, float l, float r)
{
    return square_light_share(light_opening(width_at_light(ratio, l), r));
}

// The light that reaches the point from a light without size: 0 where the surface rises above the
// light's ray at a sample of those from the point to the box's top or the light, else 1. `steps`
// are for all of the box, as a search's: a point halfway up takes half of them. What is thinner
// than a step may be missed, and the edge of a shadow is off by as much: of 20000 points before
// walls 8, 16, 32 and 64 steps are wrong for 3.3, 1.7, 0.9 and 0.4 %, of those beside a sphere for
// 1.7, 0.6, 0.2 and 0.04 %. Costs 1.25 to 1.75 times the published march: limits, a bound, and
// samples whose places do not add up roundings.
float hard_shadow(vec3 point, ReliefLight light, float texture_per_height, int steps)
{
    ReliefRay ray = relief_ray(vec3(point.xy, point.z + SHADOW_LIFT), light.direction,
                               texture_per_height);
    float way_to_light = light_distance(light);
    if (ray.velocity.z * way_to_light + (ray.start.z + 0.5) < 0.0) {
        return 0.0;
    }
    float end = min(ray.end, way_to_light);
    float share = end * max(ray.velocity.z, 1.0 / RELIEF_MAX_WAY);
    int count = relief_steps(int(ceil(float(relief_steps(steps)) * share)));
    float way = end / float(count);
    float lit = 1.0;
    for (int i = 1; i < count; ++i) {
        vec3 position = relief_position(ray, float(i) * way);
        // Below the box's top a height beyond it, and a NaN, are told as they would be in the box.
        if (solid_height(position.xy) > position.z) {
            lit = 0.0;
            break;
        }
    }
    return lit;
}

// The vertical plane through a point and a light.
struct LightPlane {
    ReliefRay ground;  // level, from the point towards the light, as far as something may hide it
    float cosine;      // of the light's elevation
    float sine;
    float distance;
    float size;  // radius over distance: the tangent of the angle that the radius takes
};

LightPlane light_plane(vec3 point, ReliefLight light, float texture_per_height)
{
    ReliefRay ray = relief_ray(vec3(point.xy, point.z + SHADOW_LIFT), light.direction,
                               texture_per_height);
    LightPlane plane;
    plane.cosine = length(ray.velocity.xy) / relief_texture_per_height(texture_per_height);
    plane.sine = ray.velocity.z;
    plane.distance = light_distance(light);
    plane.size = light_radius(light) / plane.distance;

    // To where even the box's top is below the light's lower edge, or to that edge itself.
    float forward = plane.cosine + plane.sine * plane.size;
    float upward = plane.sine - plane.cosine * plane.size;
    float room = (0.5 - ray.start.z) * forward;
    float end = room < RELIEF_MAX_WAY * upward ? room / upward : RELIEF_MAX_WAY;
    vec2 bearing = plane.cosine > 1e-6 ? ray.velocity.xy / plane.cosine : vec2(0.0);
    plane.ground = ReliefRay(ray.start, vec3(bearing, 0.0),
                             min(end, max(plane.distance * forward, 0.0)));
    return plane;
}

// How much of the light is seen past a height of `above` over the point after the way t.
float opening_past(LightPlane plane, float t, float above)
{
    float across = t * plane.sine - above * plane.cosine;
    float along = t * plane.cosine + above * plane.sine;
    return along < plane.distance ? light_opening(across, along * plane.size) : 1.0;
}

float opening_at(LightPlane plane, float t)
{
    return opening_past(plane, t, relief_gaps(plane.ground, t, RELIEF_SOLID).y);
}

// The way to a sample: evenly spaced over two box heights, and further apart the further they are
// where the way is longer, for what is near hides more.
float ground_way(LightPlane plane, int sample_index, int count)
{
    float even = plane.ground.end > 2.0 ? 2.0 / plane.ground.end : 1.0;
    float part = float(sample_index) / float(count);
    return plane.ground.end * part * (even + (1.0 - even) * part);
}

// The least opening along the surface, -1 .. 1, for square_light_share and disc_light_share: of
// `steps` samples, then of two more for each of `iterations` halvings of the step around the least.
// The least that is found is within 3e-4 of an edge's (1e-3 of a wall's, with 16 halvings), for
// lights of 0.02 and more; 8, 16, 32 and 64 steps lose 4.0, 1.5, 0.4 and 0.1 % of the edges of a
// sphere by more than 2e-3 of the light, and 3.7, 1.3, 0.7 and 0.4 % of those of walls. Costs 2
// iterations more samples than the published march, which does not refine, and 5 to 7 times its
// time on llvmpipe with 32 steps and 8 halvings: that march also stops at the box's top.
float least_opening(vec3 point, ReliefLight light, float texture_per_height, int steps,
                    int iterations)
{
    LightPlane plane = light_plane(point, light, texture_per_height);
    // The floor under the light.
    float least = light_opening(plane.sine * plane.distance + (plane.ground.start.z + 0.5),
                                plane.cosine * light_radius(light));
    int count = relief_steps(steps);
    int least_at = 0;
    for (int i = 1; i <= count; ++i) {
        float opening = opening_at(plane, ground_way(plane, i, count));
        if (opening < least) {
            least = opening;
            least_at = i;
        }
    }
    float t = ground_way(plane, least_at, count);
    float way = ground_way(plane, least_at + 1, count) - t;
    int halvings = least_at > 0 && least > -1.0 ? clamp(iterations, 0, 24) : 0;
    for (int i = 0; i < halvings; ++i) {
        way *= 0.5;
        float before = opening_at(plane, max(t - way, 0.0));
        float after = opening_at(plane, t + way);
        if (min(before, after) < least) {
            t = before < after ? max(t - way, 0.0) : t + way;
            least = min(before, after);
        }
    }
    return least;
}

// The share of a disc-shaped light that reaches the point.
float soft_shadow(vec3 point, ReliefLight light, float texture_per_height, int steps,
                  int iterations)
{
    return disc_light_share(least_opening(point, light, texture_per_height, steps, iterations));
}

// The share of a square light.
float soft_shadow_square(vec3 point, ReliefLight light, float texture_per_height, int steps,
                         int iterations)
{
    return square_light_share(least_opening(point, light, texture_per_height, steps, iterations));
}

// How much of the light is seen over a horizon, for the two shares: `horizon` is the tangent of its
// elevation towards the light, which a horizon map holds (thesis 2.4.2, figure 33). NaN and what is
// below 0 count as 0, more than 1e6 as that. Heights and distances play no part.
float horizon_opening(ReliefLight light, float horizon)
{
    ReliefRay ray = relief_ray(vec3(0.0), light.direction, 1.0);
    float cosine = length(ray.velocity.xy);
    float slope = horizon > 0.0 ? min(horizon, 1e6) : 0.0;
    float across = ray.velocity.z - slope * cosine;
    float along = cosine + slope * ray.velocity.z;
    return light_opening(across, along * (light_radius(light) / light_distance(light)));
}

// The share of a disc-shaped light that is seen over that horizon.
float horizon_light(ReliefLight light, float horizon)
{
    return disc_light_share(horizon_opening(light, horizon));
}

#endif
