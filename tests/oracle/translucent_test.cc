#include "oracle/translucent.h"

#include "interface.h"

namespace etalon::oracle {
namespace {

constexpr std::size_t kRows = 10000;

struct Passage {
    Big cosine;
    Big reflected;
    Big transmitted;
    std::vector<Big> left;
};

// Columns of a row: the direction, and n1, n2, thickness, half_distance, absorb_color.
Passage Pass(const Row& row, std::size_t direction, std::size_t layer) {
    const Big cosine = Big(row[direction + 2]) / Sqrt(ExactDot(row, direction, direction));
    const Interface face(row[layer], row[layer + 1], cosine);
    Passage passage = {cosine, face.Reflected(), face.Transmitted(), {}};
    const Big halvings = Big(row[layer + 2]) / face.cos_t / Big(row[layer + 3]);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        passage.left.push_back(face.total ? Big(0)
                                          : Exp2(-(halvings * Big(row[layer + 4 + channel]))));
    }
    return passage;
}

void AddColor(Row& row, Random& random) {
    for (int channel = 0; channel < 3; ++channel) {
        row.push_back(random.Below(8) == 0 ? 0 : random.Float(0, 1));
    }
}

Row RandomDirection(Random& random) {
    while (true) {
        const Row row = {random.Float(-1, 1), random.Float(-1, 1), random.Float(0, 1)};
        const double length = std::hypot(row[0], row[1], row[2]);
        if (length > 0.5 && length < 1.5 && row[2] > 0.02 * length) {
            return row;
        }
    }
}

// Directions, then the layer; the cosines inside are within the bounds' domain.
Row RandomLayer(Random& random, std::size_t directions) {
    while (true) {
        Row row;
        for (std::size_t k = 0; k < directions; ++k) {
            const Row direction = RandomDirection(random);
            row.insert(row.end(), direction.begin(), direction.end());
        }
        row.push_back(random.Float(1, 4));
        row.push_back(random.Below(4) == 0 ? row.back() : random.Float(1, 4));
        row.push_back(random.Below(8) == 0 ? 0 : random.Float(0, 2));
        row.push_back(random.Float(1.0 / 16, 4));
        AddColor(row, random);
        bool inside = true;
        for (std::size_t k = 0; k < directions; ++k) {
            const Big cosine = Big(row[3 * k + 2]) / Sqrt(ExactDot(row, 3 * k, 3 * k));
            const Interface face(row[3 * directions], row[3 * directions + 1], cosine);
            inside = inside && Big(0.1) < face.cos_t;
        }
        if (inside) {
            return row;
        }
    }
}

TEST(Translucent, LightKeepsItsBound) {
    Random random(1);
    std::vector<Row> rows;
    for (std::size_t k = 0; k < kRows; ++k) {
        rows.push_back(RandomLayer(random, 1));
    }
    ExpectBound("translucent.light", rows, [](const Row& row) {
        const Passage lamp = Pass(row, 0, 3);
        std::vector<Big> light;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            light.push_back(lamp.transmitted * lamp.left[channel]);
        }
        return light;
    });
}

TEST(Translucent, FlatKeepsItsBound) {
    Random random(2);
    std::vector<Row> rows;
    for (std::size_t k = 0; k < kRows; ++k) {
        Row row = RandomLayer(random, 2);
        for (int color = 0; color < 4; ++color) {
            AddColor(row, random);
        }
        rows.push_back(row);
    }
    ExpectBound("translucent.flat", rows, [](const Row& row) {
        const Passage eye = Pass(row, 0, 6);
        const Passage lamp = Pass(row, 3, 6);
        const Big ratio = Big(row[6]) / Big(row[7]);
        std::vector<Big> light;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const Big irradiance = Big(row[22 + channel]) * lamp.cosine * lamp.transmitted *
                                   lamp.left[channel] * ratio * ratio;
            light.push_back(eye.reflected * Big(row[16 + channel]) +
                            eye.transmitted * eye.left[channel] * Big(row[13 + channel]) *
                                (Big(row[19 + channel]) + irradiance));
        }
        return light;
    });
}

TEST(Translucent, NothingPassesATotallyReflectingFace) {
    Random random(3);
    std::vector<Row> rows;
    while (rows.size() < 1000) {
        const double slope = random.Float(0.1, 0.5);
        Row row = {1, 0, slope, 2, 1, random.Float(0, 2), 1};
        AddColor(row, random);
        rows.push_back(row);
    }
    const Worst worst = Compare(*FindFunction("translucent.light"), rows, [](const Row&) {
        return std::vector<Big>{0, 0, 0};
    });
    EXPECT_EQ(worst.used, 0) << worst.Text();
}

}  // namespace
}  // namespace etalon::oracle
