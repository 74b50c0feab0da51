// Heights: the field of texels from which maps are baked.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace etalon::bake {

// Told after each part of the work, of which there are `parts` equal ones. May be empty.
using PartDone = std::function<void(std::int64_t parts)>;

inline void Tell(const PartDone& done, std::int64_t parts) {
    if (done) {
        done(parts);
    }
}

// Lengths are in texels in every direction: a height of 2 is as long as two texels are wide. The
// field repeats, and is bilinear between the texels' centres, which lie at integers.
class Heights {
  public:
    // `texels` are width * height heights, row by row.
    Heights(int width, int height, std::vector<double> texels);

    int width() const { return width_; }
    int height() const { return height_; }
    double lowest() const { return lowest_; }
    double highest() const { return highest_; }

    // The texel in column i and row j, any integers.
    double Texel(int i, int j) const {
        return texels_[static_cast<std::size_t>(Wrapped(j, height_)) *
                           static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(Wrapped(i, width_))];
    }
    // Between the texels.
    double At(double x, double y) const;

    static int Wrapped(int i, int size) {
        const int rest = i % size;
        return rest < 0 ? rest + size : rest;
    }

  private:
    int width_;
    int height_;
    std::vector<double> texels_;
    double lowest_;
    double highest_;
};

// What a cell's four texels make of the heights between them: corner (i, j) and its right and upper
// neighbours.
struct Cell {
    Cell(const Heights& heights, int i, int j);

    double base;
    double slope_x;  // along y = 0
    double slope_y;  // along x = 0
    double twist;
    double lowest;
    double highest;

    double Steepest() const;  // the length of the greatest gradient
};

}  // namespace etalon::bake
