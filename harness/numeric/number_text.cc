#include "numeric/number_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr std::string_view kNames[] = {"float", "int", "uint", "bool"};

std::string_view Trim(std::string_view text) {
    constexpr std::string_view kSpaces = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(kSpaces);
    if (begin == std::string_view::npos) {
        return {};
    }
    return text.substr(begin, text.find_last_not_of(kSpaces) + 1 - begin);
}

Error NotA(Scalar scalar, std::string_view text) {
    const std::string_view name = ScalarName(scalar);
    return Error{"'" + std::string(text) + "' is not " + (scalar == Scalar::kInt ? "an " : "a ") +
                 std::string(name)};
}

Error DoesNotFit(Scalar scalar, std::string_view text) {
    return Error{"'" + std::string(text) + "' does not fit " +
                 (scalar == Scalar::kInt ? "an " : "a ") + std::string(ScalarName(scalar))};
}

// True where a number that is out of range is out of it at the small end. Its first digit that is
// not zero stands at 10^order (decimal) or 16^order (hexadecimal), with the exponent beside it.
bool IsTiny(std::string_view digits, bool hexadecimal) {
    const std::size_t mark = digits.find_first_of(hexadecimal ? "pP" : "eE");
    const std::string_view mantissa = digits.substr(0, mark);
    long long exponent = 0;
    if (mark != std::string_view::npos) {
        std::string_view tail = digits.substr(mark + 1);
        if (tail.starts_with('+')) {
            tail.remove_prefix(1);
        }
        const auto [end, code] = std::from_chars(tail.begin(), tail.end(), exponent);
        if (code == std::errc::result_out_of_range) {
            return tail.starts_with('-');
        }
    }
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_not_of("0.");
    if (first == std::string_view::npos) {
        return true;
    }
    const auto order = static_cast<long long>(point) - static_cast<long long>(first);
    return exponent + (hexadecimal ? 4 * order : order) < 0;
}

constexpr std::string_view kNanMark = "nan:";
constexpr std::uint32_t kNan = 0x7fc00000;
constexpr std::uint32_t kSign = 0x80000000;

// The bits of a NaN, eight hexadecimal digits.
Result<std::uint32_t> ParseNan(std::string_view whole) {
    const std::string_view digits = whole.substr(kNanMark.size());
    std::uint32_t word = 0;
    const auto [end, code] = std::from_chars(digits.begin(), digits.end(), word, 16);
    const bool read = code == std::errc() && end == digits.end() && digits.size() == 8;
    if (!read || !std::isnan(FromBits(word))) {
        return NotA(Scalar::kFloat, whole);
    }
    return word;
}

Result<std::uint32_t> ParseFloat(std::string_view whole) {
    if (whole.starts_with(kNanMark)) {
        return ParseNan(whole);
    }
    std::string_view text = whole;
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    const std::uint32_t sign = negative ? kSign : 0;
    if (text == "inf") {
        return sign | 0x7f800000u;
    }
    if (text == "nan") {
        return sign | kNan;
    }
    const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
    if (hexadecimal) {
        text.remove_prefix(2);
    }
    const bool starts_well =
        !text.empty() && (text[0] == '.' || (text[0] >= '0' && text[0] <= '9') ||
                          (hexadecimal && std::isxdigit(text[0]) != 0));
    if (!starts_well) {
        return NotA(Scalar::kFloat, whole);
    }
    float value = 0;
    const auto [end, code] =
        std::from_chars(text.data(), text.data() + text.size(), value,
                        hexadecimal ? std::chars_format::hex : std::chars_format::general);
    if (code == std::errc::invalid_argument || end != text.data() + text.size()) {
        return NotA(Scalar::kFloat, whole);
    }
    if (code == std::errc::result_out_of_range) {
        if (!IsTiny(text, hexadecimal)) {
            return DoesNotFit(Scalar::kFloat, whole);
        }
        value = 0;
    } else if (std::isinf(value)) {
        return DoesNotFit(Scalar::kFloat, whole);
    }
    return sign | ToBits(value);
}

Result<std::uint32_t> ParseInteger(Scalar scalar, std::string_view whole) {
    std::string_view text = whole;
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    int base = 10;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        text.remove_prefix(2);
        base = 16;
    }
    std::uint64_t magnitude = 0;
    const auto [end, code] = std::from_chars(text.begin(), text.end(), magnitude, base);
    if (code == std::errc::invalid_argument || end != text.end()) {
        return NotA(scalar, whole);
    }
    const std::uint64_t limit = scalar == Scalar::kUint ? (negative ? 0 : 0xffffffffu)
                                                        : (negative ? 0x80000000u : 0x7fffffffu);
    if (code == std::errc::result_out_of_range || magnitude > limit) {
        return DoesNotFit(scalar, whole);
    }
    const auto word = static_cast<std::uint32_t>(magnitude);
    return negative ? 0u - word : word;
}

template <typename Number, typename... Format>
void AppendNumber(std::string& text, Number number, Format... format) {
    char digits[64];
    const auto [end, code] = std::to_chars(digits, digits + sizeof digits, number, format...);
    text.append(digits, end);
}

}  // namespace

std::string_view ScalarName(Scalar scalar) {
    return kNames[static_cast<std::size_t>(scalar)];
}

std::optional<Scalar> ScalarFromName(std::string_view name) {
    for (std::size_t k = 0; k < std::size(kNames); ++k) {
        if (kNames[k] == name) {
            return static_cast<Scalar>(k);
        }
    }
    return std::nullopt;
}

Result<std::uint32_t> ParseWord(Scalar scalar, std::string_view text) {
    text = Trim(text);
    switch (scalar) {
        case Scalar::kFloat:
            return ParseFloat(text);
        case Scalar::kInt:
        case Scalar::kUint:
            return ParseInteger(scalar, text);
        case Scalar::kBool:
            break;
    }
    if (text == "true" || text == "1") {
        return 1u;
    }
    if (text == "false" || text == "0") {
        return 0u;
    }
    return NotA(scalar, text);
}

std::string WordText(Scalar scalar, std::uint32_t word) {
    std::string text;
    AppendWord(text, scalar, word);
    return text;
}

std::string ExactText(Scalar scalar, std::uint32_t word) {
    if (scalar != Scalar::kFloat || !std::isnan(FromBits(word))) {
        return WordText(scalar, word);
    }
    if ((word & ~kSign) == kNan) {
        return word == kNan ? "nan" : "-nan";
    }
    char digits[8];
    // Never fewer than eight: the least NaN is 7f800001.
    std::to_chars(digits, digits + sizeof digits, word, 16);
    return std::string(kNanMark) + std::string(digits, sizeof digits);
}

void AppendWord(std::string& text, Scalar scalar, std::uint32_t word) {
    switch (scalar) {
        case Scalar::kFloat:
            if (const float value = FromBits(word); std::isnan(value)) {
                text += "nan";
            } else {
                AppendNumber(text, value);
            }
            break;
        case Scalar::kInt:
            AppendNumber(text, static_cast<std::int32_t>(word));
            break;
        case Scalar::kUint:
            AppendNumber(text, word);
            break;
        case Scalar::kBool:
            text += word != 0 ? "true" : "false";
            break;
    }
}

double WordValue(Scalar scalar, std::uint32_t word) {
    switch (scalar) {
        case Scalar::kFloat:
            return FromBits(word);
        case Scalar::kInt:
            return static_cast<std::int32_t>(word);
        case Scalar::kUint:
            return word;
        case Scalar::kBool:
            break;
    }
    return word != 0 ? 1 : 0;
}

std::string HexFloat(float value) {
    return HexFloat(static_cast<double>(value));
}

std::string HexFloat(double value) {
    if (std::isnan(value)) {
        return "nan";
    }
    std::string text = std::signbit(value) ? "-" : "";
    if (std::isinf(value)) {
        return text + "inf";
    }
    text += "0x";
    AppendNumber(text, std::fabs(value), std::chars_format::hex);
    return text;
}

std::string Shortest(double value) {
    std::string text;
    if (std::isnan(value)) {
        return "nan";
    }
    AppendNumber(text, value);
    return text;
}

}  // namespace etalon
