// SPDX-License-Identifier: MIT
#pragma once

namespace ifs {

// Unit roundoff of doubles: the relative error of one rounded operation is at most this.
inline constexpr double roundingUnit = 0x1p-53;

} // namespace ifs
