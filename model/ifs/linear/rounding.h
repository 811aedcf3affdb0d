// SPDX-License-Identifier: MIT
#pragma once

namespace ifs {

// Unit roundoff of doubles: the relative error of one rounded operation is at most this.
inline constexpr double roundingUnit = 0x1p-53;

// Bounds what a product of two matrices loses where its terms underflow.
inline constexpr double underflow = 0x1p-1060;

} // namespace ifs
