// Maps of one value, whatever it is.
uniform float color;

vec3 blurred(vec2 uv, int level)
{
    return vec3(color);
}
