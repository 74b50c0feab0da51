// The position that the fragment stage has: that in light space.
vec3 fragment_position(vec3 position)
{
    return position;
}
