// SPDX-License-Identifier: MIT
#include "animation/frame_rate.h"

#include <cmath>
#include <cstdint>

namespace animation {

namespace {

constexpr std::int64_t maxTerm = 1'000'000;
constexpr int televised[] = {24, 30, 48, 60, 120, 240}; // also offered slowed down by 1000/1001

// The broadcast rate from which a decimal with two or more digits behind the point was rounded.
std::optional<FrameRate> televisedRate(const Moment& decimal) {
    if (decimal.denominator <= 10) return std::nullopt;
    const double value = double(decimal.numerator) / double(decimal.denominator);
    for (const int rate : televised) {
        const double slowed = rate * 1000.0 / 1001;
        for (const double scale : {100.0, 1000.0})
            if (value == std::round(slowed * scale) / scale) return FrameRate{rate * 1000, 1001};
    }
    return std::nullopt;
}

} // namespace

std::optional<FrameRate> parseRate(std::string_view text) {
    const auto rate = parseMoment(text); // same notation
    if (!rate || rate->numerator <= 0 || rate->numerator > maxTerm || rate->denominator > maxTerm ||
        rate->numerator > maxRate * rate->denominator)
        return std::nullopt;
    const bool isDecimal = text.find('/') == std::string_view::npos;
    if (const auto known = isDecimal ? televisedRate(*rate) : std::nullopt) return known;
    return FrameRate{int(rate->numerator), int(rate->denominator)};
}

std::string rateText(const FrameRate& rate) {
    const Moment reduced = moment(rate.frames, rate.seconds);
    const FrameRate wanted{int(reduced.numerator), int(reduced.denominator)};
    if (wanted.seconds == 1) return std::to_string(wanted.frames);
    const std::int64_t thousandths =
        (2000 * reduced.numerator + reduced.denominator) / (2 * reduced.denominator);
    std::string text = std::to_string(1000 + thousandths % 1000);
    text.front() = '.';
    text.insert(0, std::to_string(thousandths / 1000));
    while (text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
    if (parseRate(text) == wanted) return text;
    return std::to_string(wanted.frames) + '/' + std::to_string(wanted.seconds);
}

} // namespace animation
