// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace attractor {

// sRGB transfer function: code value 0 … 255 → linear light 0 … 1, and back to the nearest code value.
double linearLight(std::uint8_t code);
std::uint8_t encoded(double linear);
// The same with codes as fractions, exact to about 1e-12.
double linearFromEncoded(double code);
double encodedFromLinear(double linear);

} // namespace attractor
