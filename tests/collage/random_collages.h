// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/target.h"

#include <random>
#include <vector>

// Collages for tests of what is promised about them, and what is true.
namespace random_collages {

struct Collage {
    collage::Mask mask; // of side × side pixels
    std::vector<ifs::AffineMap<2>> maps;
};

// Three discs and two to four maps, whose norms are at most 0.85.
Collage contracting(std::mt19937& random, int side = 24);
// The same, seen in coordinates that are stretched: one map at least stretches, and long words contract.
Collage stretching(std::mt19937& random, int side = 24);

// Between which numbers of cells d_H(L, A) lies, L the squares of a target: from points of A in squares of
// side `step`. `widening` is C/(1 − γ) of a norm in which the maps contract; 1/(1 − s) in the Euclidean one.
struct Truth {
    double least = 0;
    double most = 0;
};
Truth distanceToAttractor(const collage::Target& target, const std::vector<ifs::AffineMap<2>>& maps,
                          double widening, double step = 0.5);

} // namespace random_collages
