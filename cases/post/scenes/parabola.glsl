// A picture whose brightness is a parabola: mean + slope . uv + bend . (uv * uv).
uniform float mean;
uniform vec2 slope;
uniform vec2 bend;

vec3 picture(vec2 uv)
{
    return vec3(mean + dot(slope, uv) + dot(bend, uv * uv));
}
