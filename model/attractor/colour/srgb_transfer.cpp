// SPDX-License-Identifier: MIT
#include "attractor/colour/srgb_transfer.h"

#include "attractor/arithmetic/arithmetic.h"

#include <algorithm>
#include <array>

namespace attractor {

double linearFromEncoded(double code) {
    return code <= 0.04045 ? code / 12.92 : power((code + 0.055) / 1.055, 2.4);
}

double encodedFromLinear(double linear) {
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * power(linear, 1 / 2.4) - 0.055;
}

double linearLight(std::uint8_t code) {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = linearFromEncoded(static_cast<double>(i) / 255);
        return values;
    }();
    return table[code];
}

std::uint8_t encoded(double linear) {
    const double code = encodedFromLinear(std::clamp(linear, 0.0, 1.0)) * 255 + 0.5;
    return static_cast<std::uint8_t>(std::min(code, 255.0));
}

} // namespace attractor
