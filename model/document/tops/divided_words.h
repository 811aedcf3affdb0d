// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <cstddef>
#include <optional>

namespace document {

// The least number of maps to which both systems come when maps are divided into words one by one:
// 1 + lcm(n − 1, m − 1). nullopt where there is none, or more than this.
inline constexpr std::size_t maxDividedMaps = 1000;
std::optional<std::size_t> commonMapCount(std::size_t n, std::size_t m);

// Divides words until the entry has `count` active maps, with the same attractor and measure: the map that
// stretches most, w_σ, becomes w_σ w_1, …, w_σ w_N in its place. An entry that has `count` already stays as
// it is. Maps that are off go. An order of the maps that the entry keeps becomes that of the words, so every
// address keeps its place; one that does not fit is given up. Requires a plane system whose number of active
// maps can come to `count`; moved branches come back, and the animation ends.
Fractal withWordsDivided(const Fractal& fractal, std::size_t count);

} // namespace document
