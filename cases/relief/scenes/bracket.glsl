#include "relief/ray.glsl"

// Whether a refined hit's way and bracket lie in the bracket of the search that it began with.
bool within_bracket(ReliefHit searched, ReliefHit refined)
{
    return refined.t_above >= searched.t_above && refined.t_below <= searched.t_below &&
           (refined.layer == RELIEF_NONE ||
            (refined.t >= refined.t_above && refined.t <= refined.t_below));
}
