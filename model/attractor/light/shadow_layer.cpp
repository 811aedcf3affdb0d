// SPDX-License-Identifier: MIT
#include "attractor/light/shadow_layer.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace attractor {

namespace {

constexpr double full8 = 255;
constexpr double full16 = 65535;

using Light = std::array<double, 4>; // premultiplied alpha, red, green, blue, 0 … 1

Light over(const Light& front, const Light& back) {
    Light result;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = front[i] + (1 - front[0]) * back[i];
    return result;
}

Light faded(Light light, double opacity) {
    for (double& part : light)
        part *= opacity;
    return light;
}

Light lightOf(std::uint32_t pixel) {
    Light light;
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = static_cast<double>(pixel >> (24 - 8 * i) & 0xFFU) / full8;
    return light;
}

Light lightOf(const Rgba16& pixel) {
    const double alpha = pixel.alpha / full16;
    return {alpha, alpha * pixel.red / full16, alpha * pixel.green / full16, alpha * pixel.blue / full16};
}

Light lightOf(const Rgba& colour) {
    const double alpha = colour.alpha / full8;
    return {alpha, alpha * colour.red / full8, alpha * colour.green / full8, alpha * colour.blue / full8};
}

std::uint32_t code(double value, double full) {
    return static_cast<std::uint32_t>(std::clamp(value * full + 0.5, 0.0, full));
}

void store(const Light& light, std::uint32_t& pixel) {
    const std::uint32_t alpha = code(light[0], full8);
    const auto channel = [&](std::size_t i) { return std::min(alpha, code(light[i], full8)); };
    pixel = alpha << 24 | channel(1) << 16 | channel(2) << 8 | channel(3);
}

void store(const Light& light, Rgba16& pixel) {
    if (!(light[0] > 0)) {
        pixel = {};
        return;
    }
    const auto channel = [&](std::size_t i) {
        return static_cast<std::uint16_t>(code(light[i] / light[0], full16));
    };
    pixel = {channel(1), channel(2), channel(3), static_cast<std::uint16_t>(code(light[0], full16))};
}

template <class Pixel>
void layUnder(const ShadowLayer& layer, std::span<Pixel> picture, std::span<const Pixel> shadow) {
    const Light ground = lightOf(layer.background);
    Pixel nothing{};
    store(ground, nothing);
    for (std::size_t i = 0; i < picture.size(); ++i) {
        if (picture[i] == Pixel{} && shadow[i] == Pixel{})
            picture[i] = nothing;
        else
            store(over(lightOf(picture[i]), over(faded(lightOf(shadow[i]), layer.opacity), ground)),
                  picture[i]);
    }
}

} // namespace

void ShadowLayer::putUnder(std::span<std::uint32_t> picture, std::span<const std::uint32_t> shadow) const {
    layUnder(*this, picture, shadow);
}

void ShadowLayer::putUnder(std::span<Rgba16> picture, std::span<const Rgba16> shadow) const {
    layUnder(*this, picture, shadow);
}

} // namespace attractor
