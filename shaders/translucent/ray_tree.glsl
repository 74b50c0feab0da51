// The tree of rays that a ray becomes in a stack of flat layers: at each face it splits in a
// mirrored and a refracted one. Branches that carry too little are cut.
#ifndef ETALON_TRANSLUCENT_RAY_TREE
#define ETALON_TRANSLUCENT_RAY_TREE

#include "../optics/absorption.glsl"
#include "../optics/fresnel.glsl"

// Rays that wait, and rays in all. A ray leaves at most one waiting.
const int RAY_TREE_DEPTH = 32;
const int RAY_TREE_MAX_RAYS = 1024;

// Shares of the light that came, which sum to 1.
struct RayTree {
    float reflected;    // left the stack towards where it came from
    float transmitted;  // left it on the other side
    float absorbed;
    float cut;  // in branches that were cut: the others may be too small by this, together
    int rays;   // how many there were, the first one included
};

// Two layers between two media, three faces. The four indices are those of the media from where the
// light comes to where it goes; thickness, half_distance (absorption.glsl) and the components of
// what is below are those of the two layers; cos_i is the cosine in the first medium. A ray that
// carries less than `least` of the light, 0 .. 1, is cut. As wide layers are, the stack is
// incoherent: energies add, each polarisation for itself. For a single slab the last two indices
// are equal. Never more than 32 rays wait, nor are there more than 1024: what is beyond is cut.
// Inputs are clamped as in slab.glsl, and none yields NaN. Error: 1e-6 beside the share that was
// cut.
// Costs one step of some 40 operations a ray; slab_shares is the closed form of the tree that is
// never cut, for one slab.
// Source: thesis section 4.1.2, which names the growth of the tree, and 3.2.2.
RayTree trace_layers(vec4 indices, vec2 thickness, vec2 half_distance, float cos_i, float least)
{
    vec4 n = vec4(optics_clamp_index(indices.x), optics_clamp_index(indices.y),
                  optics_clamp_index(indices.z), optics_clamp_index(indices.w));
    float smallest = optics_limit(least, 0.0, 1.0);
    float cosine = optics_limit(cos_i, 0.0, 1.0);

    // Faces and layers are met at the same angles each time: their shares are made once. Angles
    // follow from the first by Snell's law whatever is between. A face's shares are the same from
    // both sides, and exact from the thinner one; one behind which no light can be reflects all.
    vec4 face[3];
    float layer[2];
    bool open = true;
    for (int i = 0; i < 3; ++i) {
        float behind = cos_transmitted(n.x, n[i + 1], cos_i);
        open = open && !total_internal_reflection(n.x, n[i + 1], cos_i);
        bool thinner = n[i + 1] < n[i];
        face[i] = open ? optics_fresnel(thinner ? n[i + 1] : n[i], thinner ? n[i] : n[i + 1],
                                        thinner ? behind : cosine)
                       : vec4(1.0, 1.0, 0.0, 0.0);
        cosine = behind;
        if (i < 2) {
            float way = optics_limit(thickness[i], 0.0, 1.0e30) / max(cosine, 1.0 / 4096.0);
            layer[i] = transmitted_fraction(way, half_distance[i]);
        }
    }

    // A ray arrives at a face from above (down) or below it, with the light of both polarisations.
    vec2 waiting_light[RAY_TREE_DEPTH];
    int waiting_face[RAY_TREE_DEPTH];
    bool waiting_down[RAY_TREE_DEPTH];
    RayTree tree = RayTree(0.0, 0.0, 0.0, 0.0, 1);
    int waiting = 1;
    waiting_light[0] = vec2(0.5);
    waiting_face[0] = 0;
    waiting_down[0] = true;
    for (int ray = 0; ray < RAY_TREE_MAX_RAYS && waiting > 0; ++ray) {
        --waiting;
        vec2 light = waiting_light[waiting];
        int at = waiting_face[waiting];
        bool down = waiting_down[waiting];
        for (int part = 0; part < 2; ++part) {
            bool mirrored = part == 0;
            vec2 share = light * (mirrored ? face[at].xy : face[at].zw);
            bool goes_down = down != mirrored;
            int next = goes_down ? at + 1 : at - 1;
            float amount = share.x + share.y;
            if (next < 0) {
                tree.reflected += amount;
            } else if (next > 2) {
                tree.transmitted += amount;
            } else {
                vec2 arriving = share * layer[goes_down ? at : at - 1];
                tree.absorbed += (share.x - arriving.x) + (share.y - arriving.y);
                amount = arriving.x + arriving.y;
                if (amount < smallest || amount <= 0.0 || waiting == RAY_TREE_DEPTH ||
                    tree.rays == RAY_TREE_MAX_RAYS) {
                    tree.cut += amount;
                } else {
                    waiting_light[waiting] = arriving;
                    waiting_face[waiting] = next;
                    waiting_down[waiting] = goes_down;
                    ++waiting;
                    ++tree.rays;
                }
            }
        }
    }
    return tree;
}

#endif
