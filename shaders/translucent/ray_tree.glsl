// The tree of rays that a ray becomes in a stack of flat layers: at each face it splits in a
// mirrored and a refracted one. Branches that carry too little are cut.
#ifndef ETALON_TRANSLUCENT_RAY_TREE
#define ETALON_TRANSLUCENT_RAY_TREE

#include "../optics/absorption.glsl"
#include "../optics/fresnel.glsl"

const int RAY_TREE_MAX_GENERATIONS = 512;

// Shares of the light that came, which sum to 1.
struct RayTree {
    float reflected;    // left the stack towards where it came from
    float transmitted;  // left it on the other side
    float absorbed;
    float cut;  // in branches that were cut: the others may be too small by this, together
    int rays;   // how many faces were met
};

// Adds what one way across a layer absorbs of `light`, and what of the rest is cut; the rest.
vec2 ray_tree_cross(vec2 light, float left, float least, inout RayTree tree)
{
    vec2 arriving = light * left;
    float amount = arriving.x + arriving.y;
    tree.absorbed += (light.x - arriving.x) + (light.y - arriving.y);
    if (amount > 0.0 && amount >= least) {
        ++tree.rays;
        return arriving;
    }
    tree.cut += amount;
    return vec2(0.0);
}

// The shares of a face for light of both polarisations, with these cosines before it and behind.
// They are the same from both sides, and exact from the thinner one.
vec4 ray_tree_face(float n_before, float n_behind, float before, float behind)
{
    bool thinner = n_behind < n_before;
    return optics_fresnel(thinner ? n_behind : n_before, thinner ? n_before : n_behind,
                          thinner ? behind : before);
}

// Two layers between two media, three faces. The four indices are those of the media from where the
// light comes to where it goes; thickness and half_distance (absorption.glsl) are those of the two
// layers; cos_i is the cosine in the first medium. As the layers are flat, rays of one generation
// that meet a face from the same side are one: the tree has at most two, whatever its depth, and no
// stack of rays that wait. A ray that carries less than `least` of the light, 0 .. 1, is cut, and
// all are after 512 generations. The layers are wide, so that light is incoherent: energies add,
// each polarisation for itself. For a single slab the last two indices are equal.
// Inputs are clamped as in slab.glsl, and none yields NaN. Error: 5e-7 beside the share that was
// cut, and 2e-5 where faces reflect nearly all, for hundreds of generations. slab_shares is the closed form of the tree that is never cut, for one slab.
// Source: thesis section 4.1.2, which names the growth of the tree, and 3.2.2.
RayTree trace_layers(vec4 indices, vec2 thickness, vec2 half_distance, float cos_i, float least)
{
    vec4 n = vec4(optics_clamp_index(indices.x), optics_clamp_index(indices.y),
                  optics_clamp_index(indices.z), optics_clamp_index(indices.w));
    float smallest = optics_limit(least, 0.0, 1.0);
    // Angles follow from the first one by Snell's law, whatever is between.
    vec4 cosine = vec4(optics_limit(cos_i, 0.0, 1.0), cos_transmitted(n.x, n.y, cos_i),
                       cos_transmitted(n.x, n.z, cos_i), cos_transmitted(n.x, n.w, cos_i));
    const vec4 closed = vec4(1.0, 1.0, 0.0, 0.0);
    vec4 face0 = cosine.y > 0.0 ? ray_tree_face(n.x, n.y, cosine.x, cosine.y) : closed;
    vec4 face1 = cosine.z > 0.0 ? ray_tree_face(n.y, n.z, cosine.y, cosine.z) : closed;
    vec4 face2 = cosine.w > 0.0 ? ray_tree_face(n.z, n.w, cosine.z, cosine.w) : closed;
    vec2 left = vec2(1.0);
    for (int i = 0; i < 2; ++i) {
        float way = optics_limit(thickness[i], 0.0, 1.0e30) / max(cosine[i + 1], 1.0 / 4096.0);
        left[i] = transmitted_fraction(way, half_distance[i]);
    }

    // What arrives at the end of a layer: xy goes down, zw up.
    RayTree tree = RayTree(0.5 * (face0.x + face0.y), 0.0, 0.0, 0.0, 1);
    vec4 first = vec4(ray_tree_cross(0.5 * face0.zw, left.x, smallest, tree), 0.0, 0.0);
    vec4 second = vec4(0.0);
    for (int i = 0; i < RAY_TREE_MAX_GENERATIONS && first + second != vec4(0.0); ++i) {
        vec2 out_before = face0.zw * first.zw;
        vec2 out_behind = face2.zw * second.xy;
        tree.reflected += out_before.x + out_before.y;
        tree.transmitted += out_behind.x + out_behind.y;
        vec4 next = vec4(
            ray_tree_cross(face0.xy * first.zw, left.x, smallest, tree),
            ray_tree_cross(face1.xy * first.xy + face1.zw * second.zw, left.x, smallest, tree));
        second = vec4(
            ray_tree_cross(face1.zw * first.xy + face1.xy * second.zw, left.y, smallest, tree),
            ray_tree_cross(face2.xy * second.xy, left.y, smallest, tree));
        first = next;
    }
    tree.cut += dot(first + second, vec4(1.0));
    return tree;
}

#endif
