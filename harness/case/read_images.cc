#include "case/read_images.h"

#include <algorithm>
#include <array>

#include "case/read_domain.h"

namespace etalon {
namespace {

constexpr unsigned kChannels = 4;
constexpr std::size_t kCubeFaces = 6;

class ImageReader {
  public:
    ImageReader(const TomlReader& reader, const std::string& name, const toml::table& table)
        : reader_(reader), table_(table), what_("image '" + name + "'") {
        image_.name = name;
        image_.place = reader.PlaceOf(table);
    }

    Result<ImageSource> Read() {
        ETALON_TRY_STEP(reader_.OnlyKeys(
            table_, {"file", "expr", "size", "filter", "wrap", "levels", "cube", "bake", "slices",
                     "bearings", "texels_per_height", "published", "scale", "level"}));
        if (table_.contains("file") == table_.contains("expr")) {
            return reader_.Fail(table_, what_ + ": needs either file or expr");
        }
        ETALON_TRY(is_cube, FlagAt("cube"));
        image_.shape = is_cube ? ImageShape::kCube : ImageShape::kFlat;
        ETALON_TRY(levels, FlagAt("levels"));
        image_.levels = levels;
        ETALON_TRY(filter, ChoiceAt("filter", {"linear", "nearest"}));
        image_.sampling.filter = filter == 0 ? Filter::kLinear : Filter::kNearest;
        ETALON_TRY(wrap, ChoiceAt("wrap", {"repeat", "clamp"}));
        image_.sampling.wrap = wrap == 0 ? Wrap::kRepeat : Wrap::kClamp;
        if (is_cube && table_.contains("wrap")) {
            return reader_.Fail(*table_.get("wrap"), What("wrap") + " has no meaning for a cube");
        }
        ETALON_TRY_STEP(ReadFiles());
        ETALON_TRY_STEP(ReadChannels());
        ETALON_TRY_STEP(ReadSize());
        ETALON_TRY_STEP(ReadBake());
        return std::move(image_);
    }

  private:
    bool IsCube() const { return image_.shape == ImageShape::kCube; }
    std::string What(std::string_view key) const { return what_ + ": '" + std::string(key) + "'"; }

    Result<bool> FlagAt(std::string_view key) const {
        const toml::node* node = table_.get(key);
        return node == nullptr ? Result<bool>(false) : reader_.Flag(*node, What(key));
    }

    // Which of two words the key has; the first where it is absent.
    Result<int> ChoiceAt(std::string_view key, std::array<std::string_view, 2> words) const {
        const toml::node* node = table_.get(key);
        if (node == nullptr) {
            return 0;
        }
        ETALON_TRY(text, reader_.Text(*node, What(key)));
        if (text != words[0] && text != words[1]) {
            return reader_.Fail(*node, What(key) + " must be " + std::string(words[0]) + " or " +
                                           std::string(words[1]));
        }
        return text == words[0] ? 0 : 1;
    }

    Status<> ReadFiles() {
        const toml::node* node = table_.get("file");
        if (node == nullptr) {
            return Ok();
        }
        if (IsCube()) {
            ETALON_TRY(files, reader_.Texts(*node, What("file")));
            image_.files = files;
            if (files.size() != kCubeFaces) {
                return reader_.Fail(*node, What("file") +
                                               " of a cube must list its six faces: +x, "
                                               "-x, +y, -y, +z, -z");
            }
        } else {
            ETALON_TRY(file, reader_.Text(*node, What("file")));
            image_.files = {file};
        }
        if (const toml::node* size = table_.get("size")) {
            return reader_.Fail(*size, What("size") + " belongs to expr: a file has its own");
        }
        return Ok();
    }

    Status<> ReadChannels() {
        const toml::node* node = table_.get("expr");
        if (node == nullptr) {
            return Ok();
        }
        const toml::array* const list = node->as_array();
        std::vector<const toml::node*> entries;
        if (list == nullptr) {
            entries.push_back(node);
        } else {
            for (const toml::node& entry : *list) {
                entries.push_back(&entry);
            }
        }
        const std::vector<Symbol> symbols = ImageSymbols(image_.shape);
        unsigned components = 0;
        for (const toml::node* entry : entries) {
            ETALON_TRY(channel, reader_.Formula(*entry, What("expr")));
            const Result<unsigned> bound = channel.Bind(symbols);
            if (!bound) {
                return reader_.FailInside(*entry, bound.error());
            }
            components += *bound;
            image_.channels.push_back(channel);
        }
        if (components < 1 || components > kChannels) {
            return reader_.Fail(*node, What("expr") + " has " + std::to_string(components) +
                                           " components; an image has 1 to 4");
        }
        return Ok();
    }

    Status<> ReadSize() {
        if (image_.channels.empty()) {
            return Ok();
        }
        const toml::node* node = table_.get("size");
        if (node == nullptr) {
            return reader_.Fail(table_, what_ + ": 'size' is missing: expr needs it");
        }
        ETALON_TRY(list, reader_.List(*node, What("size")));
        if (list->size() != 2) {
            return reader_.Fail(*node, What("size") + " must be [width, height]");
        }
        ETALON_TRY(width, reader_.Count((*list)[0], What("size")));
        ETALON_TRY(height, reader_.Count((*list)[1], What("size")));
        const std::uint64_t faces = IsCube() ? kCubeFaces : 1;
        if (std::min(width, height) < 1 || std::max(width, height) > kMostImageSide ||
            width * height * faces > kMostTexels) {
            return reader_.Fail(*node, What("size") + " must be 1 to " +
                                           std::to_string(kMostImageSide) + " each way, at most " +
                                           std::to_string(kMostTexels) + " texels in all");
        }
        if (IsCube() && width != height) {
            return reader_.Fail(*node, What("size") + ": a cube's faces are squares");
        }
        image_.width = static_cast<std::uint32_t>(width);
        image_.height = static_cast<std::uint32_t>(height);
        return Ok();
    }

    Status<> ReadBake() {
        const toml::node* node = table_.get("bake");
        for (const std::string_view key :
             {"slices", "bearings", "texels_per_height", "published", "scale", "level"}) {
            if (node == nullptr && table_.contains(key)) {
                return reader_.Fail(*table_.get(key), What(key) + " belongs to bake");
            }
        }
        if (node == nullptr) {
            return Ok();
        }
        for (const std::string_view key : {"cube", "levels"}) {
            if (table_.contains(key)) {
                return reader_.Fail(*table_.get(key), What(key) + " has no meaning with bake");
            }
        }
        ETALON_TRY(name, reader_.Text(*node, What("bake")));
        const std::optional<bake::Kind> kind = bake::KindNamed(name);
        if (!kind) {
            return reader_.Fail(*node, What("bake") + " must be one of " + bake::KindNamesText());
        }
        bake::Plan plan;
        plan.kind = *kind;
        ETALON_TRY(published, FlagAt("published"));
        plan.published = published;
        ETALON_TRY_STEP(ReadCount("slices", plan.slices));
        ETALON_TRY_STEP(ReadCount("bearings", plan.bearings));
        ETALON_TRY(texels, NumberAt("texels_per_height"));
        plan.texels_per_height = texels;
        ETALON_TRY(scale, NumberAt("scale"));
        plan.scale = scale.value_or(1);
        ETALON_TRY(level, NumberAt("level"));
        plan.level = level.value_or(image_.files.empty() ? 0 : bake::kFileLevel);
        image_.bake = plan;
        return Ok();
    }

    Status<> ReadCount(std::string_view key, std::optional<std::uint64_t>& count) const {
        if (const toml::node* node = table_.get(key)) {
            ETALON_TRY(value, reader_.Count(*node, What(key)));
            count = value;
        }
        return Ok();
    }

    Result<std::optional<double>> NumberAt(std::string_view key) const {
        const toml::node* node = table_.get(key);
        if (node == nullptr) {
            return std::optional<double>();
        }
        ETALON_TRY(value, reader_.Number(*node, What(key)));
        return std::optional(value);
    }

    const TomlReader& reader_;
    const toml::table& table_;
    std::string what_;
    ImageSource image_;
};

}  // namespace

std::vector<Symbol> ImageSymbols(ImageShape shape) {
    if (shape == ImageShape::kCube) {
        return {{"x", 1}, {"y", 1}, {"z", 1}};
    }
    return {{"u", 1}, {"v", 1}, {"i", 1}, {"j", 1}};
}

Result<std::vector<ImageSource>> ReadImages(const TomlReader& reader, const toml::table& table) {
    std::vector<ImageSource> images;
    for (const auto& [name, node] : TomlReader::InOrder(table)) {
        if (!IsIdentifier(name)) {
            return reader.Fail(*node, "image '" + name + "': not a GLSL name");
        }
        ETALON_TRY(keys, reader.Table(*node, "image '" + name + "'"));
        ETALON_TRY(image, ImageReader(reader, name, *keys).Read());
        images.push_back(std::move(image));
    }
    return images;
}

Result<std::vector<ImageSource>> ReadImages(const std::string& text, const std::string& origin) {
    const TomlReader reader(origin);
    ETALON_TRY(table, reader.Parse(text));
    return ReadImages(reader, table);
}

}  // namespace etalon
