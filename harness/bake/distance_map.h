// The distance map: how far every point of a grid in the relief's box is from the solid.
#pragma once

#include <cstdint>
#include <vector>

#include "bake/heights.h"

namespace etalon::bake {

struct DistanceMap {
    // Slice by slice upwards, in it row by row; in texels. Slice k of n lies at the share
    // (k + 0.5) / n of the box, its points at the texels' centres.
    std::vector<double> distances;
    // Sites looked at by the passes along rows and columns: the transform's work, linear in the
    // number of distances.
    std::uint64_t steps = 0;
};

// The box reaches from floor to top; the solid is all that is not above the heights.
//
// Safe: a value read from the map, at one of its points, the nearest one or trilinear between them,
// is never greater than the distance to the solid, so that a step of that length skips nothing. It
// is less by up to the voxel's diagonal and half a texel, and is negative within the solid and
// beside it. To be clamped after it has been read and not before: interpolated between clamped
// values it would be too great.
DistanceMap SafeDistances(const Heights& heights, double floor, double top, int slices,
                          const PartDone& done = {});

// As published: the distance to the columns under the texels' centres, 0 within them. Between its
// points it may be too great.
DistanceMap SampledDistances(const Heights& heights, double floor, double top, int slices,
                             const PartDone& done = {});

}  // namespace etalon::bake
