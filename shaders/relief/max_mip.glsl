// The search on a maximum mipmap (Tevs et al.): blocks of cells that the ray passes above are
// passed whole, and in a cell the crossing with the bilinear surface is the root of a quadratic. No
// step size, and nothing that is too thin to be found.
//
// On fields of waves, bricks, noise and ridges one texel wide, 20,000 rays of all bands each, every
// hit is the first, within 7.3e-4 texels. On bricks a ray visits 11, 14, 15 and 18 blocks and cells
// at 0-45, 45-70, 70-85 and 85-89 degrees; the loop branches much.
#ifndef ETALON_RELIEF_MAX_MIP
#define ETALON_RELIEF_MAX_MIP

#include "search.glsl"

// The heights z of the solid layer's texels (i, j), (i + 1, j), (i, j + 1) and (i + 1, j + 1), any
// integers: the map repeats. The cell is what lies between their centres, and is bilinear.
vec4 solid_cell(ivec2 cell);

// The greatest height of the cells (block * 2^level) .. (block * 2^level + 2^level - 1), of any
// integers.
float max_height(ivec2 block, int level);

const int RELIEF_MAX_LEVEL = 14;

// The way to the first crossing within a cell, -1 if there is none on so much of it: of a ray that
// enters it at `place`, 0 .. 1, at the height z, and moves by `velocity` (cells, box heights).
float relief_cell_crossing(vec4 corners, vec2 place, float z, vec3 velocity, float way)
{
    float h00 = relief_height(corners.x);
    float h01 = relief_height(corners.z);
    vec2 slope = vec2(relief_height(corners.y) - h00, h01 - h00);
    float twist = (relief_height(corners.w) - h01) - slope.x;
    float gap = z - (h00 + dot(slope, place) + twist * (place.x * place.y));
    if (gap <= 0.0) {
        return 0.0;
    }
    // gap + rise * s + bend * s^2
    float rise = velocity.z - dot(slope, velocity.xy) -
                 twist * (place.x * velocity.y + place.y * velocity.x);
    float bend = -twist * velocity.x * velocity.y;
    float discriminant = rise * rise - 4.0 * gap * bend;
    if ((rise >= 0.0 && bend >= 0.0) || discriminant < 0.0) {
        return -1.0;
    }
    // Of the root's two forms the one that adds numbers of one sign: no cancellation, and a plane
    // cell (bend 0) is no special case.
    float root = sqrt(discriminant);
    float s = rise < 0.0 ? 2.0 * gap / (root - rise) : (root + rise) / (-2.0 * bend);
    return s <= way ? s : -1.0;
}

// Where a ray leaves a block of cells, along one axis.
float relief_block_exit(float start, float velocity, int first, int side)
{
    float border = float(velocity > 0.0 ? first + side : first);
    return velocity != 0.0 ? (border - start) / velocity : RELIEF_MAX_WAY + 1.0;
}

// The cell on the way along one axis after it: never behind the cell, never out of the block.
int relief_cell_in_block(float place, float velocity, int cell, int first, int side)
{
    int reached = int(floor(place));
    return velocity > 0.0 ? clamp(reached, cell, first + side - 1) : clamp(reached, first, cell);
}

// The first encounter with the solid layer, of a map of this size, whose sides are powers of two up
// to 16384. A ray that has used up its steps, one for each block and each cell, has met the solid
// where it is.
ReliefHit find_relief_by_max_mip(ReliefRay ray, ivec2 map_size, int steps)
{
    ivec2 size = clamp(map_size, ivec2(1), ivec2(1 << RELIEF_MAX_LEVEL));
    int top = 0;
    while (top < RELIEF_MAX_LEVEL && (1 << top) < max(size.x, size.y)) {
        ++top;
    }
    // In cells, from a place in the first map: the rest is lost in float for no use.
    vec2 start = fract(ray.start.xy) * vec2(size) - 0.5;
    vec3 velocity = vec3(ray.velocity.xy * vec2(size), ray.velocity.z);
    ivec2 cell = ivec2(floor(start));
    int level = top;
    float t = 0.0;
    int count = relief_steps(steps);
    for (int i = 0; i < count; ++i) {
        int side = 1 << level;
        ivec2 block = ivec2(cell.x >> level, cell.y >> level);
        ivec2 first = block * side;
        float exit_x = relief_block_exit(start.x, velocity.x, first.x, side);
        float exit_y = relief_block_exit(start.y, velocity.y, first.y, side);
        float leave = clamp(min(exit_x, exit_y), t, ray.end);
        float lowest = ray.start.z + velocity.z * (velocity.z < 0.0 ? leave : t);
        // Written so that a NaN blocks the ray.
        if (!(max_height(block, level) < lowest)) {
            if (level > 0) {
                --level;
                continue;
            }
            vec2 place = clamp(start + velocity.xy * t - vec2(cell), 0.0, 1.0);
            float way = relief_cell_crossing(solid_cell(cell), place, ray.start.z + velocity.z * t,
                                             velocity, leave - t);
            if (way >= 0.0) {
                float met = min(t + way, ray.end);
                return ReliefHit(RELIEF_SOLID, met, relief_position(ray, met), t, met);
            }
        }
        if (leave >= ray.end) {
            // A ray that ends at the floor has met it, whatever the last bits are.
            bool floor_met = ray.start.z + velocity.z * ray.end <= RELIEF_FLOOR;
            return floor_met
                       ? ReliefHit(RELIEF_SOLID, ray.end, relief_position(ray, ray.end), t, ray.end)
                       : relief_miss(ray);
        }
        ivec2 next;
        if (exit_x <= exit_y) {
            next.x = velocity.x > 0.0 ? first.x + side : first.x - 1;
            next.y = relief_cell_in_block(start.y + velocity.y * leave, velocity.y, cell.y, first.y,
                                          side);
        } else {
            next.y = velocity.y > 0.0 ? first.y + side : first.y - 1;
            next.x = relief_cell_in_block(start.x + velocity.x * leave, velocity.x, cell.x, first.x,
                                          side);
        }
        // The block above blocks the ray for as long as the ray is in it.
        bool same = next.x >> (level + 1) == cell.x >> (level + 1) &&
                    next.y >> (level + 1) == cell.y >> (level + 1);
        level = same ? level : min(level + 1, top);
        cell = next;
        t = leave;
    }
    return ReliefHit(RELIEF_SOLID, t, relief_position(ray, t), t, t);
}

#endif
