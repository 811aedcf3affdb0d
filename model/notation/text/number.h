// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

// Numbers as text: always the C locale, whatever the user's.
namespace notation {

// std::from_chars, but what is closer to 0 than any double is 0, and only what is too large is out of range.
std::from_chars_result fromChars(const char* first, const char* last, double& value,
                                 std::chars_format format = std::chars_format::general);

// A finite decimal number and nothing else (surrounding white space allowed); nullopt for 1/3, 0,5, inf, nan,
// hex, "".
std::optional<double> parseNumber(std::string_view text);

// The shortest text that reads back as the same double.
std::string formatNumber(double value);

// Without the white space of ASCII at its ends.
std::string_view trimmed(std::string_view text);

// Fractint's numbers end here; what is larger is refused by every reader, and so is what is not a number.
constexpr double maxCoefficient = std::numeric_limits<float>::max();

inline bool isCoefficient(double number) {
    return std::abs(number) <= maxCoefficient;
}

} // namespace notation
