#include "device/vulkan/names.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace etalon {
namespace {

constexpr std::array<std::string_view, 4> kCompilers = {"LLVM", "LLPC", "ACO", "Subzero"};

std::string WithoutMarks(std::string_view text) {
    std::string clean(text);
    for (const std::string_view mark : {"(R)", "(TM)", "(r)", "(tm)"}) {
        for (std::size_t at = clean.find(mark); at != std::string::npos; at = clean.find(mark)) {
            clean.replace(at, mark.size(), " ");
        }
    }
    return clean;
}

std::string Parenthesis(std::string_view text) {
    const std::string clean = WithoutMarks(text);
    const std::size_t open = clean.find('(');
    const std::size_t close = clean.find(')', open == std::string::npos ? 0 : open);
    if (open == std::string::npos || close == std::string::npos) {
        return {};
    }
    return clean.substr(open + 1, close - open - 1);
}

}  // namespace

std::string Slug(std::string_view device_name) {
    const std::string clean = WithoutMarks(device_name);
    std::string slug;
    std::string word;
    const auto end_word = [&] {
        if (!word.empty() && word != "device") {
            slug.append(slug.empty() ? "" : "-").append(word);
        }
        word.clear();
    };
    for (const char c : std::string_view(clean).substr(0, clean.find('('))) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || c == '.') {
            word += static_cast<char>(std::tolower(byte));
        } else {
            end_word();
        }
    }
    end_word();
    return slug.empty() ? "unknown" : slug;
}

std::string CompilerOf(std::string_view device_name, std::string_view driver_words) {
    for (const std::string_view text : {device_name, driver_words}) {
        std::string inside = Parenthesis(text);
        const auto names_it = [&](std::string_view compiler) {
            return inside.find(compiler) != std::string::npos;
        };
        if (std::any_of(kCompilers.begin(), kCompilers.end(), names_it)) {
            return inside;
        }
    }
    return {};
}

}  // namespace etalon
