// The searches that a family compares, put together of the library's parts: no height is read
// twice. Each returns the way to the solid layer in box heights, negative for none.
#include "relief/adaptive.glsl"

float linear_way(ReliefRay ray, int steps)
{
    return search_solid(ray, steps).t;
}

// To the middle of what so many bisections leave of the step.
float bisected_way(ReliefRay ray, int steps, int iterations)
{
    ReliefBracket bracket = search_bracket(ray, RELIEF_SOLID, steps);
    bracket = narrow_binary(ray, bracket, iterations);
    return relief_hit(ray, bracket, relief_middle(bracket)).t;
}

// To the secant's crossing in it.
float found_way(ReliefRay ray, int steps, int iterations)
{
    return find_layers(ray, RELIEF_SOLID, steps, iterations).t;
}

float secant_way(ReliefRay ray, int steps, int iterations)
{
    ReliefBracket bracket = search_bracket(ray, RELIEF_SOLID, steps);
    bracket = narrow_secant(ray, bracket, iterations);
    return relief_hit(ray, bracket, relief_secant(bracket)).t;
}

float illinois_way(ReliefRay ray, int steps, int iterations)
{
    ReliefBracket bracket = search_bracket(ray, RELIEF_SOLID, steps);
    bracket = narrow_illinois(ray, bracket, iterations);
    return relief_hit(ray, bracket, relief_secant(bracket)).t;
}

float itp_way(ReliefRay ray, int steps, int iterations)
{
    ReliefBracket bracket = search_bracket(ray, RELIEF_SOLID, steps);
    bracket = narrow_itp(ray, bracket, iterations);
    return relief_hit(ray, bracket, relief_secant(bracket)).t;
}
