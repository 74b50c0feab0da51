// A picture of any bits, brighter ones where the coordinates are no numbers.
uniform vec3 bits;

vec3 picture(vec2 uv)
{
    return bits + uv.xyx;
}
