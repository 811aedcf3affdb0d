// SPDX-License-Identifier: MIT
#include "notation/rows/numbers.h"

#include "notation/text/number.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <string>

namespace notation {

namespace {

bool allMultiplesOf(const std::vector<std::size_t>& perLine, std::size_t n) {
    return std::all_of(perLine.begin(), perLine.end(), [n](std::size_t count) { return count % n == 0; });
}

bool allEqual(const std::vector<std::size_t>& perLine, std::size_t n) {
    return std::all_of(perLine.begin(), perLine.end(), [n](std::size_t count) { return count == n; });
}

} // namespace

Number readNumber(std::string_view token) {
    const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+';
    const char* first = token.data() + (plus ? 1 : 0);
    const char* last = token.data() + token.size();
    double value = 0;
    const auto [end, error] = fromChars(first, last, value);
    if (error == std::errc::invalid_argument) return {};
    if (error == std::errc::result_out_of_range) return {Number::Kind::Huge, 0};
    if (!std::isfinite(value)) return {Number::Kind::NotFinite, 0};
    if (token.find_first_of("xX") != std::string_view::npos) return {};
    if (end != last || !isNumberEnd(last[-1])) return {Number::Kind::Trailing, value};
    if (!isCoefficient(value)) return {Number::Kind::Huge, value};
    return {Number::Kind::Good, value};
}

double valueOf(std::string_view token, bool decimalComma) {
    std::string text(token);
    if (const auto comma = text.find(','); decimalComma && comma != std::string::npos) {
        const bool isBeforeDigit =
            comma + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[comma + 1])) != 0;
        if (!isBeforeDigit || text.find('.') != std::string::npos) return std::nan("");
        text[comma] = '.';
    }
    const Number number = readNumber(text);
    return number.kind == Number::Kind::Good ? number.value : std::nan("");
}

bool isNumberEnd(char c) {
    return (c >= '0' && c <= '9') || c == '.';
}

RowShape rowShape(const std::vector<std::size_t>& perLine, bool isMarked3D) {
    const std::size_t count = std::accumulate(perLine.begin(), perLine.end(), std::size_t(0));
    if (count == 0) return {};
    if (isMarked3D) {
        if (count % 13 == 0) return {13, false, false};
        return {allMultiplesOf(perLine, 12) ? 12 : 0, false, false};
    }
    if (count % 7 == 0) return {7, false, allEqual(perLine, 6) || allEqual(perLine, 13)};
    if (allMultiplesOf(perLine, 13)) return {13, true, false};
    if (allEqual(perLine, 12)) return {12, true, false};
    return {allMultiplesOf(perLine, 6) ? 6 : 0, false, false};
}

} // namespace notation
