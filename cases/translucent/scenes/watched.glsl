// A solid with a bump before u = 0.5, which counts how often its height is asked for behind the
// point (0.5, 0.5).

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

uniform float solid_level;  // z
uniform float bump;         // z of the solid where u < 0.4995
uniform vec3 ray;           // counted are samples behind (0.5, 0.5), seen along this

int behind_count = 0;

float solid_height(vec2 uv)
{
    behind_count += dot(uv - vec2(0.5), ray.xy) < -1e-6 ? 1 : 0;
    return uv.x < 0.4995 ? bump : solid_level;
}

// How many heights were asked for behind the entry while an argument was evaluated.
int behind_of(vec3 result)
{
    int count = behind_count;
    behind_count = 0;
    return count;
}

float translucent_height(vec2 uv)
{
    return -0.5;
}

vec3 solid_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}

vec3 translucent_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}

vec3 solid_normal_texel(vec2 uv)
{
    return vec3(0.5, 0.5, 1.0);
}

vec3 translucent_normal_texel(vec2 uv)
{
    return vec3(0.5, 0.5, 1.0);
}

vec3 solid_color(vec2 uv)
{
    return vec3(1.0);
}

vec3 environment(vec3 direction)
{
    return vec3(0.0);
}
