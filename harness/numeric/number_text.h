// Numbers as text, both ways and to the same bits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace etalon {

// The scalar types of a probe's inputs and outputs.
enum class Scalar : std::uint8_t { kFloat, kInt, kUint, kBool };

std::string_view ScalarName(Scalar scalar);  // "float"
std::optional<Scalar> ScalarFromName(std::string_view name);

// The 32-bit word of a value written as decimal, hexadecimal float (0x1.8p-3), nan, -nan, inf,
// -inf or a NaN's eight hexadecimal digits (nan:7f800001) (float); decimal or 0x hexadecimal, in
// range (int, uint); true, false, 0, 1 (bool). Decimal floats round to nearest even once; a
// magnitude beyond the largest float is refused ("does not fit"), one too small becomes zero or a
// subnormal. Spaces around are allowed. The error is the reason alone: "'abc' is not a float".
Result<std::uint32_t> ParseWord(Scalar scalar, std::string_view text);

// The shortest decimal that reads back to the same bits; "nan" for every NaN, "inf", "-inf", "-0";
// "true" and "false".
std::string WordText(Scalar scalar, std::uint32_t word);
// As WordText, but a NaN keeps its bits: "nan", "-nan", "nan:7f800001".
std::string ExactText(Scalar scalar, std::uint32_t word);
// As WordText, appended: the fast door for tables.
void AppendWord(std::string& text, Scalar scalar, std::uint32_t word);

// The number that a word stands for; a bool is 0 or 1.
double WordValue(Scalar scalar, std::uint32_t word);

std::string HexFloat(float value);  // "0x1.8p-3", "-0x0p+0", "nan", "inf"
std::string HexFloat(double value);
std::string Shortest(double value);  // shortest decimal of a binary64

}  // namespace etalon
