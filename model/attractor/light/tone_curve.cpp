// SPDX-License-Identifier: MIT
#include "attractor/light/tone_curve.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/srgb_transfer.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace attractor {

namespace {

// 256 entries for each octave of light, from 2⁻²⁰ to 1.
constexpr int droppedBits = 15; // bits dropped from the 23 of a mantissa
constexpr float darkest = 0x1p-20F;
constexpr std::uint32_t firstEntry = std::bit_cast<std::uint32_t>(darkest) >> droppedBits;
constexpr std::uint32_t lastEntry = std::bit_cast<std::uint32_t>(1.0F) >> droppedBits;

// The middle of the light that shares an entry.
double lightOf(std::uint32_t entry) {
    return entry == lastEntry
               ? 1.0
               : static_cast<double>(std::bit_cast<float>(entry << droppedBits | 1U << (droppedBits - 1)));
}

} // namespace

double tone(double density, double brightness, double whitePoint, double gamma) {
    const double ratio =
        naturalLogarithm(1 + brightness * density) / naturalLogarithm(1 + brightness * whitePoint);
    return std::clamp(power(ratio, 1 / gamma), 0.0, 1.0);
}

double contrasted(double v, double contrast) {
    if (contrast == 1 || v <= 0 || v >= 1) return v;
    return 1 / (1 + power((1 - v) / v, contrast));
}

double tone(double density, const Appearance& appearance, double whitePoint) {
    return contrasted(tone(density, appearance.brightness, whitePoint, appearance.gamma),
                      appearance.contrast);
}

double vibrant(double code, const Appearance& appearance) {
    const double kept = appearance.vibrancy;
    if (kept == 1 || code <= 0 || code >= 1) return code;
    return kept * code + (1 - kept) * power(code, 1 / appearance.gamma);
}

VibrantCodes::VibrantCodes(const Appearance& appearance) {
    if (appearance.vibrancy == 1) return;
    m_codes.reserve(lastEntry - firstEntry + 1);
    for (std::uint32_t entry = firstEntry; entry <= lastEntry; ++entry)
        m_codes.push_back(static_cast<float>(255 * vibrant(encodedFromLinear(lightOf(entry)), appearance)));
}

double VibrantCodes::operator()(double linear) const {
    if (!(linear > 0)) return 0;
    const float light = std::clamp(static_cast<float>(linear), darkest, 1.0F);
    return static_cast<double>(m_codes[(std::bit_cast<std::uint32_t>(light) >> droppedBits) - firstEntry]);
}

} // namespace attractor
