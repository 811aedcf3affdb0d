// SPDX-License-Identifier: MIT
#include "notation/text/number.h"

#include <cstddef>
#include <cstdlib>

namespace notation {

namespace {

#ifdef __cpp_lib_to_chars
std::from_chars_result decimal(const char* first, const char* last, double& value, std::chars_format format) {
    return std::from_chars(first, last, value, format);
}
#else
// The library of browsers reads no such numbers yet. strtod() there rounds as well, knows no locale, and
// reads more, which is kept from it.
std::from_chars_result decimal(const char* first, const char* last, double& value, std::chars_format format) {
    const auto skipDigits = [last](const char*& at) {
        const char* const begin = at;
        while (at != last && *at >= '0' && *at <= '9')
            ++at;
        return at - begin;
    };
    const char* at = first;
    if (at != last && *at == '-') ++at;
    auto digits = skipDigits(at);
    if (at != last && *at == '.') digits += skipDigits(++at);
    if (digits == 0) return {first, std::errc::invalid_argument};
    if (format == std::chars_format::general && at != last && (*at == 'e' || *at == 'E')) {
        const char* power = at + 1;
        if (power != last && (*power == '-' || *power == '+')) ++power;
        if (skipDigits(power) > 0) at = power;
    }
    const double read = std::strtod(std::string(first, at).c_str(), nullptr);
    if (!std::isfinite(read)) return {at, std::errc::result_out_of_range};
    value = read;
    return {at, std::errc()};
}
#endif

// The power of ten of the first digit that is not 0, of the text of a number.
double magnitude(const char* first, const char* last) {
    double power = -1;
    bool isFraction = false;
    bool isFound = false;
    const char* at = first;
    for (; at != last && *at != 'e' && *at != 'E'; ++at) {
        if (*at == '.') {
            isFraction = true;
            continue;
        }
        if (*at < '0' || *at > '9') continue;
        isFound = isFound || *at != '0';
        if (isFound && !isFraction) ++power;
        if (!isFound && isFraction) --power;
    }
    if (at == last) return power;
    double exponent = 0;
    const bool isNegative = ++at != last && *at == '-';
    if (at != last && (*at == '-' || *at == '+')) ++at;
    for (; at != last && *at >= '0' && *at <= '9'; ++at)
        exponent = 10 * exponent + (*at - '0');
    return isNegative ? power - exponent : power + exponent;
}

} // namespace

std::from_chars_result fromChars(const char* first, const char* last, double& value,
                                 std::chars_format format) {
    std::from_chars_result result = decimal(first, last, value, format);
    if (result.ec == std::errc::result_out_of_range && magnitude(first, result.ptr) < 0) {
        value = 0;
        result.ec = {};
    }
    return result;
}

std::optional<double> parseNumber(std::string_view text) {
    const std::string_view digits = trimmed(text);
    const char* first = digits.data();
    const char* last = first + digits.size();
    if (first != last && *first == '+') {
        ++first;
        if (first != last && *first == '-') return std::nullopt;
    }
    double value = 0;
    const auto result = fromChars(first, last, value);
    if (result.ec != std::errc() || result.ptr != last || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string formatNumber(double value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value == 0 ? 0.0 : value);
    return {buffer, result.ptr};
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\n\v\f\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

} // namespace notation
