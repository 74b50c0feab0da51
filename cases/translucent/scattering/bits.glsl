// Maps of any bits.
uniform vec3 sharp;
uniform vec3 soft;

vec3 blurred(vec2 uv, int level)
{
    return level > 0 ? soft : sharp;
}
