// The tree of rays that a ray becomes in a stack of flat layers: at each face it splits in a
// mirrored and a refracted one. Branches that carry too little are cut.
#ifndef ETALON_TRANSLUCENT_RAY_TREE
#define ETALON_TRANSLUCENT_RAY_TREE

#include "../optics/absorption.glsl"
#include "../optics/fresnel.glsl"

// Rays in all.
const int RAY_TREE_MAX_RAYS = 1024;

// Shares of the light that came, which sum to 1.
struct RayTree {
    float reflected;    // left the stack towards where it came from
    float transmitted;  // left it on the other side
    float absorbed;
    float cut;  // in branches that were cut: the others may be too small by this, together
    int rays;   // how many there were, the first one included
};

// A face's shares are the same from both sides, and exact from the thinner one; one behind which no
// light can be reflects all.
vec4 ray_tree_face(float n1, float n2, float cos_before, float cos_behind, bool open)
{
    bool thinner = n2 < n1;
    return open ? optics_fresnel(thinner ? n2 : n1, thinner ? n1 : n2,
                                 thinner ? cos_behind : cos_before)
                : vec4(1.0, 1.0, 0.0, 0.0);
}

float ray_tree_layer(float thickness, float half_distance, float cosine)
{
    float way = optics_limit(thickness, 0.0, 1.0e30) / max(cosine, 1.0 / 4096.0);
    return transmitted_fraction(way, half_distance);
}

// A ray that leaves one face, as it arrives at the next; zero where it is cut.
vec2 ray_tree_arrival(vec2 light, float left, float least, inout RayTree tree)
{
    vec2 arriving = light * left;
    float amount = arriving.x + arriving.y;
    tree.absorbed += (light.x - arriving.x) + (light.y - arriving.y);
    if (amount < least || amount <= 0.0 || tree.rays == RAY_TREE_MAX_RAYS) {
        tree.cut += amount;
        return vec2(0.0);
    }
    ++tree.rays;
    return arriving;
}

// Two layers between two media, three faces. The four indices are those of the media from where the
// light comes to where it goes; thickness, half_distance (absorption.glsl) and the components of
// what is below are those of the two layers; cos_i is the cosine in the first medium. Branches that
// meet at one face, on one side and after equally many faces, go on as one ray. A ray that carries
// less than `least` of the light, 0 .. 1, is cut. As wide layers are, the stack is incoherent:
// energies add, each polarisation for itself. For a single slab the last two indices are equal.
// There are never more than 1024 rays: what is beyond is cut. Inputs are clamped as in slab.glsl,
// and none yields NaN. Error: 1e-6 beside the share that was cut.
// Costs one step of some 15 operations a ray; slab_shares is the closed form of the tree that is
// never cut, for one slab. No array: softpipe (Mesa 22.3) stores to an indexed element of one of
// four neighbouring rows in all of them, and zink cannot compile a stack of rays that wait.
// Source: thesis section 4.1.2, which names the growth of the tree, and 3.2.2.
RayTree trace_layers(vec4 indices, vec2 thickness, vec2 half_distance, float cos_i, float least)
{
    vec4 n = vec4(optics_clamp_index(indices.x), optics_clamp_index(indices.y),
                  optics_clamp_index(indices.z), optics_clamp_index(indices.w));
    float smallest = optics_limit(least, 0.0, 1.0);
    float cosine = optics_limit(cos_i, 0.0, 1.0);

    // Faces and layers are met at the same angles each time: their shares are made once. Angles
    // follow from the first by Snell's law whatever is between.
    float upper_cosine = cos_transmitted(n.x, n.y, cosine);
    float lower_cosine = cos_transmitted(n.x, n.z, cosine);
    bool upper_open = !total_internal_reflection(n.x, n.y, cosine);
    bool lower_open = upper_open && !total_internal_reflection(n.x, n.z, cosine);
    bool last_open = lower_open && !total_internal_reflection(n.x, n.w, cosine);
    vec4 top = ray_tree_face(n.x, n.y, cosine, upper_cosine, upper_open);
    vec4 middle = ray_tree_face(n.y, n.z, upper_cosine, lower_cosine, lower_open);
    vec4 bottom = ray_tree_face(n.z, n.w, lower_cosine, cos_transmitted(n.x, n.w, cosine),
                                last_open);
    float upper = ray_tree_layer(thickness.x, half_distance.x, upper_cosine);
    float lower = ray_tree_layer(thickness.y, half_distance.y, lower_cosine);

    // The light of both polarisations that arrives at a face from above (down) or below it (up).
    RayTree tree = RayTree(0.0, 0.0, 0.0, 0.0, 1);
    vec2 down_top = vec2(0.5);
    vec2 up_top = vec2(0.0);
    vec2 down_middle = vec2(0.0);
    vec2 up_middle = vec2(0.0);
    vec2 down_bottom = vec2(0.0);
    for (int faces = 0; faces < RAY_TREE_MAX_RAYS; ++faces) {
        vec2 reflected = down_top * top.xy + up_top * top.zw;
        vec2 transmitted = down_bottom * bottom.zw;
        tree.reflected += reflected.x + reflected.y;
        tree.transmitted += transmitted.x + transmitted.y;
        vec2 upper_down = down_top * top.zw + up_top * top.xy;
        vec2 upper_up = down_middle * middle.xy + up_middle * middle.zw;
        vec2 lower_down = down_middle * middle.zw + up_middle * middle.xy;
        vec2 lower_up = down_bottom * bottom.xy;
        down_top = vec2(0.0);
        down_middle = ray_tree_arrival(upper_down, upper, smallest, tree);
        up_top = ray_tree_arrival(upper_up, upper, smallest, tree);
        down_bottom = ray_tree_arrival(lower_down, lower, smallest, tree);
        up_middle = ray_tree_arrival(lower_up, lower, smallest, tree);
        vec2 left = (down_middle + up_top) + (down_bottom + up_middle);
        if (left.x + left.y <= 0.0) {
            break;
        }
    }
    return tree;
}

#endif
