#include "run/images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "image/levels.h"
#include "image/read.h"
#include "numeric/number_text.h"
#include "run/image_shelf.h"

namespace etalon {
namespace {

constexpr std::size_t kChannels = 4;
constexpr std::array<float, kChannels> kAbsent = {0, 0, 0, 1};

// Columns of ImageSymbols(source.shape) at all texels, in the order of Image::rgba.
std::vector<std::vector<double>> TexelColumns(const Image& image) {
    std::vector<std::vector<double>> columns(ImageSymbols(image.shape).size());
    for (std::uint32_t face = 0; face < FaceCount(image); ++face) {
        for (std::uint32_t j = 0; j < image.height; ++j) {
            for (std::uint32_t i = 0; i < image.width; ++i) {
                const double u = (i + 0.5) / image.width;
                const double v = (j + 0.5) / image.height;
                std::array<double, 4> values = {u, v, double(i), double(j)};
                if (image.shape == ImageShape::kCube) {
                    const Direction through = CubeDirection(face, u, v);
                    const double length = std::hypot(through.x, through.y, through.z);
                    values = {through.x / length, through.y / length, through.z / length};
                }
                for (std::size_t k = 0; k < columns.size(); ++k) {
                    columns[k].push_back(values[k]);
                }
            }
        }
    }
    return columns;
}

Result<Image> Compute(const ImageSource& source) {
    Image image;
    image.width = source.width;
    image.height = source.height;
    image.shape = source.shape;
    const std::size_t texels = LevelSize(image, 0).texels() * FaceCount(image);
    image.rgba.resize(kChannels * texels);
    for (std::size_t texel = 0; texel < texels; ++texel) {
        std::copy(kAbsent.begin(), kAbsent.end(), image.rgba.data() + kChannels * texel);
    }
    const std::vector<std::vector<double>> columns = TexelColumns(image);
    std::vector<const double*> pointers;
    for (const std::vector<double>& column : columns) {
        pointers.push_back(column.data());
    }
    std::size_t channel = 0;
    std::vector<Expression::Value> values;
    for (const Expression& expression : source.channels) {
        expression.Evaluate(pointers, texels, values);
        for (std::size_t first = 0; first < values.size(); first += texels) {
            for (std::size_t texel = 0; texel < texels; ++texel) {
                const auto value = static_cast<float>(values[first + texel].value);
                if (!std::isfinite(value)) {
                    const std::size_t row = texel / image.width;
                    return Error{"'" + expression.text() + "' is " +
                                 Shortest(values[first + texel].value) + " at column " +
                                 std::to_string(texel % image.width) + " of row " +
                                 std::to_string(row % image.height) +
                                 (image.shape == ImageShape::kCube
                                      ? " of face " + std::to_string(row / image.height)
                                      : "") +
                                 ": no finite number in binary32"};
                }
                image.rgba[kChannels * texel + channel] = value;
            }
            ++channel;
        }
    }
    return image;
}

Result<Image> ReadFaces(const ImageSource& source, const std::filesystem::path& base) {
    Image whole;
    for (const std::string& file : source.files) {
        ETALON_TRY(face, ReadImage(base / file));
        if (whole.rgba.empty()) {
            whole = std::move(face);
            continue;
        }
        if (face.width != whole.width || face.height != whole.height) {
            return Error{(base / file).string() + ": has not the size of the cube's first face"};
        }
        whole.rgba.insert(whole.rgba.end(), face.rgba.begin(), face.rgba.end());
    }
    whole.shape = source.shape;
    if (whole.shape == ImageShape::kCube && whole.width != whole.height) {
        return Error{(base / source.files[0]).string() + ": a cube's faces are squares"};
    }
    return whole;
}

Status<> Add(BoundImage bound, Call& call) {
    for (const BoundImage& other : call.images) {
        if (other.name == bound.name) {
            return Error{"image '" + bound.name + "': the sampler has an image already"};
        }
    }
    call.images.push_back(std::move(bound));
    return Ok();
}

}  // namespace

Result<Image> MakeImage(const ImageSource& source, const std::filesystem::path& base) {
    Result<Image> image = source.files.empty() ? Compute(source) : ReadFaces(source, base);
    if (image && source.bake) {
        image = bake::Bake(*image, *source.bake);
    }
    if (!image) {
        return Error{source.place.Text() + "image '" + source.name + "': " + image.error().message};
    }
    if (source.levels) {
        AddLevels(*image);
    }
    return image;
}

Status<> AddImages(std::span<const ImageSource> sources, const std::filesystem::path& base,
                   Call& call) {
    for (const ImageSource& source : sources) {
        ETALON_TRY(image, SharedImage(source, base));
        const auto added = Add({source.name, std::move(image), source.sampling}, call);
        if (!added) {
            return Error{source.place.Text() + added.error().message};
        }
    }
    return Ok();
}

Status<> AddWith(const std::vector<std::string>& with, const std::filesystem::path& base,
                 Call& call) {
    for (const std::string& one : with) {
        const std::size_t equals = one.find('=');
        if (equals == std::string::npos) {
            call.with.push_back(base / one);
            continue;
        }
        ETALON_TRY(image, ReadImage(base / one.substr(equals + 1)));
        ETALON_TRY_STEP(Add(
            {one.substr(0, equals), std::make_shared<const Image>(std::move(image)), {}}, call));
    }
    return Ok();
}

}  // namespace etalon
