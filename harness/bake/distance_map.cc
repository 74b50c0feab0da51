#include "bake/distance_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace etalon::bake {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Columns of the safe map to a texel, each way.
constexpr int kDetail = 4;

// Squared distances along a line that repeats: at the points 0, spacing, 2 spacing ... the least of
// (x - site)^2 * unit^2 + value[site] over all sites, by the lower envelope of these parabolas
// (Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions").
class LineTransform {
  public:
    LineTransform(int sites, int spacing, double unit)
        : sites_(sites), spacing_(spacing), unit_(unit) {
        // Half the line again on both sides: whatever is farther has a nearer image.
        vertices_.resize(2 * static_cast<std::size_t>(sites) + 2);
        starts_.resize(vertices_.size());
    }

    // Value(site) for sites 0 .. sites - 1; Store(k, squared distance) for each point.
    template <typename Value, typename Store>
    void Run(Value&& value, Store&& store) {
        const int first = -(sites_ / 2) - 1;
        const int last = sites_ + sites_ / 2;
        std::size_t count = 0;
        for (int site = first; site <= last; ++site) {
            ++steps_;
            const double x = site * unit_;
            const double height = value(Heights::Wrapped(site, sites_)) + x * x;
            double start = -kInfinity;
            while (count > 0) {
                const Vertex& other = vertices_[count - 1];
                start = (height - other.height) / (2 * (x - other.x));
                if (start > starts_[count - 1]) {
                    break;
                }
                --count;
                ++steps_;
                start = -kInfinity;
            }
            vertices_[count] = {x, height};
            starts_[count] = start;
            ++count;
        }
        std::size_t k = 0;
        for (int point = 0; point * spacing_ < sites_; ++point) {
            const double x = point * spacing_ * unit_;
            while (k + 1 < count && starts_[k + 1] <= x) {
                ++k;
                ++steps_;
            }
            ++steps_;
            const double squared = vertices_[k].height - 2 * x * vertices_[k].x + x * x;
            store(point, std::max(squared, 0.0));
        }
    }

    std::uint64_t steps() const { return steps_; }

  private:
    struct Vertex {
        double x;
        double height;  // of the parabola, with its x^2
    };

    int sites_;
    int spacing_;
    double unit_;
    std::vector<Vertex> vertices_;
    std::vector<double> starts_;  // where each vertex begins to be the nearest
    std::uint64_t steps_ = 0;
};

// The distances to vertical columns, `detail` of them to a texel each way.
DistanceMap ToColumns(const Heights& heights, const std::vector<double>& tops, int detail,
                      double floor, double top, int slices, const PartDone& done) {
    const int columns = heights.width() * detail;
    const int rows = heights.height() * detail;
    const auto width = static_cast<std::size_t>(heights.width());
    LineTransform along_row(columns, detail, 1.0 / detail);
    LineTransform along_column(rows, detail, 1.0 / detail);
    DistanceMap map;
    map.distances.resize(width * static_cast<std::size_t>(heights.height()) *
                         static_cast<std::size_t>(slices));
    std::vector<double> across(width * static_cast<std::size_t>(rows));
    double* slice = map.distances.data();
    for (int k = 0; k < slices; ++k) {
        const double z = floor + (top - floor) * ((k + 0.5) / slices);
        for (int row = 0; row < rows; ++row) {
            const double* const of_row =
                tops.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(columns);
            double* const into = across.data() + static_cast<std::size_t>(row) * width;
            along_row.Run(
                [&](int site) {
                    const double above = std::max(z - of_row[site], 0.0);
                    return above * above;
                },
                [&](int point, double squared) { into[point] = squared; });
        }
        for (std::size_t column = 0; column < width; ++column) {
            along_column.Run(
                [&](int site) { return across[static_cast<std::size_t>(site) * width + column]; },
                [&](int point, double squared) {
                    slice[static_cast<std::size_t>(point) * width + column] = std::sqrt(squared);
                });
        }
        slice += width * static_cast<std::size_t>(heights.height());
        Tell(done, slices);
    }
    map.steps = along_row.steps() + along_column.steps();
    return map;
}

// The greatest height within a column's own distance of it, each way: what lies between four
// columns is then not higher than any of them, and no nearer than the nearest.
std::vector<double> RaisedColumns(const Heights& heights, int detail) {
    const int columns = heights.width() * detail;
    const int rows = heights.height() * detail;
    std::vector<double> at;
    at.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            at.push_back(heights.At(static_cast<double>(column) / detail,
                                    static_cast<double>(row) / detail));
        }
    }
    const auto greatest = [](const std::vector<double>& of, int width, int height, int dx, int dy) {
        std::vector<double> result;
        result.reserve(of.size());
        const auto value = [&](int x, int y) {
            return of[static_cast<std::size_t>(Heights::Wrapped(y, height)) *
                          static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(Heights::Wrapped(x, width))];
        };
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                result.push_back(
                    std::max({value(x - dx, y - dy), value(x, y), value(x + dx, y + dy)}));
            }
        }
        return result;
    };
    return greatest(greatest(at, columns, rows, 1, 0), columns, rows, 0, 1);
}

}  // namespace

DistanceMap SafeDistances(const Heights& heights, double floor, double top, int slices,
                          const PartDone& done) {
    DistanceMap map =
        ToColumns(heights, RaisedColumns(heights, kDetail), kDetail, floor, top, slices, done);
    // The distance at a point is not less than that at a voxel's corner without the way between
    // them, and the mean way to the corners, weighted as they are read, is at most half a diagonal.
    const double between_slices = (top - floor) / slices;
    const double most = 0.5 * std::sqrt(2 + between_slices * between_slices);
    const double rounding = 0x1p-18 * (top - floor);  // of binary32, here and in a shader
    for (double& distance : map.distances) {
        distance -= most + rounding;
    }
    return map;
}

DistanceMap SampledDistances(const Heights& heights, double floor, double top, int slices,
                             const PartDone& done) {
    std::vector<double> tops;
    for (int j = 0; j < heights.height(); ++j) {
        for (int i = 0; i < heights.width(); ++i) {
            tops.push_back(heights.Texel(i, j));
        }
    }
    return ToColumns(heights, tops, 1, floor, top, slices, done);
}

}  // namespace etalon::bake
