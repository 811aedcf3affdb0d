// SPDX-License-Identifier: MIT
#pragma once

#include "collage/fit/constraints.h"
#include "collage/target/target.h"

#include <cstdint>
#include <vector>

namespace collage {

// Similarities that map the target into itself, roughly: each takes its mean to one of its cells, far from
// those of the others, with any angle; one in three mirrors. Then they meet the constraints. The same seed
// and index give the same maps on every machine. In grid coordinates.
std::vector<ifs::AffineMap<2>> randomStart(const Target& target, int maps, const Constraints& constraints,
                                           std::uint64_t seed, std::uint64_t index);

// Systems like those of ferns and spirals, which random maps hardly ever meet: the first map that is no stem
// has a norm from 0.7 to 0.9 and, of many such similarities, takes the target into itself best; the others
// are smaller, lie where that one leaves something uncovered, and fit into the target as well. Same promises.
std::vector<ifs::AffineMap<2>> ledStart(const Target& target, int maps, const Constraints& constraints,
                                        std::uint64_t seed, std::uint64_t index);

} // namespace collage
