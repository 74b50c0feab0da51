// OpenEXR files of a test's own making: uncompressed, with any channels, in binary32.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace etalon {

struct ExrFile {
    std::int32_t left = 0;  // the data window's origin
    std::int32_t top = 0;
    std::int32_t width = 1;
    std::int32_t height = 1;
    std::int32_t sampling = 1;                                // of all channels
    std::map<std::string, std::vector<float>> channels = {};  // row by row

    std::string Bytes() const {
        std::string text;
        Append(text, std::uint32_t{20000630});
        Append(text, std::uint32_t{2});
        std::string list;
        for (const auto& [name, values] : channels) {
            list += name + '\0';
            for (const std::int32_t number : {2, 0, sampling, sampling}) {
                Append(list, number);
            }
        }
        Attribute(text, "channels", "chlist", list + '\0');
        Attribute(text, "compression", "compression", std::string(1, '\0'));
        std::string window;
        for (const std::int32_t number : {left, top, left + width - 1, top + height - 1}) {
            Append(window, number);
        }
        Attribute(text, "dataWindow", "box2i", window);
        Attribute(text, "displayWindow", "box2i", window);
        Attribute(text, "lineOrder", "lineOrder", std::string(1, '\0'));
        std::string one;
        Append(one, 1.0f);
        Attribute(text, "pixelAspectRatio", "float", one);
        Attribute(text, "screenWindowCenter", "v2f", std::string(8, '\0'));
        Attribute(text, "screenWindowWidth", "float", one);
        text += '\0';
        const std::size_t line = channels.size() * static_cast<std::size_t>(width) * 4;
        const std::size_t start = text.size() + static_cast<std::size_t>(height) * 8;
        for (std::int32_t row = 0; row < height; ++row) {
            Append(text, std::uint64_t{start + static_cast<std::size_t>(row) * (line + 8)});
        }
        for (std::int32_t row = 0; row < height; ++row) {
            Append(text, top + row);
            Append(text, static_cast<std::uint32_t>(line));
            for (const auto& [name, values] : channels) {
                for (std::int32_t column = 0; column < width; ++column) {
                    Append(text, values[static_cast<std::size_t>(row * width + column)]);
                }
            }
        }
        return text;
    }

  private:
    template <typename T>
    static void Append(std::string& text, T value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        text.append(bytes, sizeof value);
    }
    static void Attribute(std::string& text, const std::string& name, const std::string& type,
                          const std::string& value) {
        text += name + '\0' + type + '\0';
        Append(text, static_cast<std::uint32_t>(value.size()));
        text += value;
    }
};

}  // namespace etalon
