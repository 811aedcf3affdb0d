// SPDX-License-Identifier: MIT
#include "animation/keys/moment.h"

#include <algorithm>
#include <charconv>
#include <numeric>

namespace animation {

namespace {

// Digits and nothing else, at most `most`.
std::optional<std::int64_t> whole(std::string_view text, std::int64_t most) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isNumber = error == std::errc() && end == text.data() + text.size() && text.front() != '-';
    return isNumber && number <= most ? std::optional(number) : std::nullopt;
}

std::optional<Moment> within(const Moment& moment) {
    return isAfter(moment, 2 * std::int64_t(maxLength)) ? std::nullopt : std::optional(moment);
}

std::int64_t remainder(std::int64_t dividend, std::int64_t divisor) {
    const std::int64_t rest = dividend % divisor;
    return rest < 0 ? rest + divisor : rest;
}

} // namespace

Moment moment(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t divisor = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
    return {numerator / divisor, denominator / divisor};
}

std::optional<Moment> parseMoment(std::string_view text) {
    constexpr std::int64_t maxNumerator = maxDenominator * maxLength * 2;
    if (const std::size_t slash = text.find('/'); slash != std::string_view::npos) {
        const auto above = whole(text.substr(0, slash), maxNumerator);
        const auto below = whole(text.substr(slash + 1), maxDenominator);
        if (!above || !below || *below == 0) return std::nullopt;
        return within(moment(*above, *below));
    }
    const std::size_t point = std::min(text.find('.'), text.size());
    std::string_view fraction = text.substr(std::min(point + 1, text.size()));
    if (point < text.size() && fraction.empty()) return std::nullopt;
    while (!fraction.empty() && fraction.back() == '0')
        fraction.remove_suffix(1);
    const auto before = whole(text.substr(0, point), 2 * std::int64_t(maxLength));
    const auto after =
        fraction.empty() ? std::optional<std::int64_t>(0) : whole(fraction, maxDenominator - 1);
    if (!before || !after || fraction.size() > 9) return std::nullopt;
    std::int64_t scale = 1;
    for (std::size_t digit = 0; digit < fraction.size(); ++digit)
        scale *= 10;
    return within(moment(*before * scale + *after, scale));
}

bool isAfter(const Moment& moment, std::int64_t frame) {
    return moment.numerator > frame * moment.denominator;
}

bool isBefore(const Moment& a, const Moment& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
}

int frameCount(Loop loop, int length) {
    switch (loop) {
    case Loop::Cycle:
        return length;
    case Loop::ThereAndBack:
        return 2 * length;
    case Loop::Off:
        break;
    }
    return length + 1;
}

int lastFrame(Loop loop, int length) {
    return loop == Loop::ThereAndBack ? 2 * length : length;
}

Moment folded(const Moment& moment, Loop loop, int length) {
    const std::int64_t end = length * moment.denominator;
    std::int64_t at = moment.numerator;
    switch (loop) {
    case Loop::Off:
        at = std::clamp<std::int64_t>(at, 0, end);
        break;
    case Loop::Cycle:
        at = remainder(at, end);
        break;
    case Loop::ThereAndBack:
        at = remainder(at, 2 * end);
        at = std::min(at, 2 * end - at);
        break;
    }
    return animation::moment(at, moment.denominator);
}

double phase(const Moment& moment, int length, int cycles) {
    const std::int64_t whole = length * moment.denominator;
    return double(remainder(remainder(moment.numerator, whole) * cycles, whole)) / double(whole);
}

} // namespace animation
