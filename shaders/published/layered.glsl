// Layered media as the article computes them, flaws included. What its pixel shader reads from
// textures comes from the scene: inner_layer at a mip level, which this method never uses.
//
// Source: Oat, "Rendering Semitransparent Layered Media", equation (1) and both listings.
#ifndef ETALON_PUBLISHED_LAYERED
#define ETALON_PUBLISHED_LAYERED

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

vec3 inner_layer(vec2 uv, float level);

// The direction to the eye v, mirrored at the unit normal n; tangent space.
vec3 mirrored_vector(vec3 v, vec3 n)
{
    return -v + (2.0 * dot(v, n)) * n;
}

// The mirrored vector turned into the surface. Flaw: not refracted, and a tilted normal moves it to
// the wrong side.
vec3 transmission_vector(vec3 mirrored)
{
    return vec3(mirrored.xy, -mirrored.z);
}

// The way to the inner layer at depth d, in texels. Flaw: infinite along the surface, and the same
// for a vector that points out of it.
float transmission_distance(float d, vec3 transmission)
{
    return d / abs(transmission.z);
}

// The texture coordinate at which the inner layer is seen. Flaw: right for square maps only.
vec2 offset_coordinate(vec2 uv, float s, vec3 transmission)
{
    return uv + (1.0 / 512.0) * (s * transmission.xy);
}

// The offset in texels (xy) and the way (z) to the inner layer at depth d, by the three above.
vec3 layer_way(vec3 v, vec3 n, float d)
{
    vec3 transmission = transmission_vector(mirrored_vector(v, n));
    float s = transmission_distance(d, transmission);
    return vec3(s * transmission.xy, s);
}

// How far the filter reaches, in texels, for a way of s.
float blur_radius(float s)
{
    return s;
}

// The mean of the inner layer at uv and at twelve points about it, radius texels away at most.
// Flaws: the points' mean is not their centre, their spread is no circle, and far ones miss all
// that lies between them.
vec3 growable_filter_rgb(vec2 uv, vec2 pixel_size, float radius)
{
    const vec2 taps[12] = vec2[12](
        vec2(-0.326212, -0.40581), vec2(-0.840144, -0.07358), vec2(-0.695914, 0.457137),
        vec2(-0.203345, 0.620716), vec2(0.96234, -0.194983), vec2(0.473434, -0.480026),
        vec2(0.519456, 0.767022), vec2(0.185461, -0.893124), vec2(0.507431, 0.064425),
        vec2(0.89642, 0.412458), vec2(-0.32194, -0.932615), vec2(-0.791559, -0.59771));
    vec3 sum = inner_layer(uv, 0.0);
    for (int i = 0; i < 12; ++i) {
        sum += inner_layer(uv + pixel_size * (radius * taps[i]), 0.0);
    }
    return sum / 13.0;
}

// Outer and inner colour by the transparency of the outer layer and the cosine between normal and
// eye. Flaw: the listing squares the cosine, the text does not.
vec3 blend_layers(vec3 outer, vec3 inner, float transparency, float n_dot_v)
{
    float cosine = clamp(n_dot_v, 0.0, 1.0);
    return mix(outer, inner, transparency * cosine * cosine);
}

// Flaw: all of the specular light is added to all of the diffuse light.
vec3 light_layers(vec3 base, float n_dot_l, vec3 specular)
{
    return base * clamp(n_dot_l, 0.0, 1.0) + specular;
}

// The depth of the inner layer at a time, in texels. Flaw: said to be 0 to 4, is -4 to 4.
float layer_depth(float time)
{
    return sin(time) * 4.0;
}

// A vector of tangent space in world space; the axes are the rows of the inverse tangent space.
// Flaw: interpolated axes are shorter than one.
vec3 tangent_to_world(vec3 v, vec3 tangent, vec3 binormal, vec3 normal)
{
    return vec3(dot(tangent, v), dot(binormal, v), dot(normal, v));
}

// The whole pixel: `outer` is the outer layer's colour, with its transparency in alpha, and
// `specular` what the environment shows along the mirrored vector.
vec3 layered_color(vec2 uv, vec3 to_eye, vec3 to_light, vec3 normal, vec4 outer, vec3 specular,
                   float d)
{
    vec3 transmission = transmission_vector(mirrored_vector(to_eye, normal));
    float s = transmission_distance(d, transmission);
    vec3 inner = growable_filter_rgb(offset_coordinate(uv, s, transmission), vec2(1.0 / 512.0),
                                     blur_radius(s));
    vec3 base = blend_layers(outer.rgb, inner, outer.a, dot(normal, to_eye));
    return light_layers(base, dot(normal, to_light), specular);
}

#endif
