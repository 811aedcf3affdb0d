// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/target.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

// Targets for the tests of collages.
namespace drawings {

// Pixels whose centre belongs to the shape, in coordinates from −1 to 1 with y up.
collage::Mask drawn(int side, const std::function<bool(double x, double y)>& isInside);

struct Drawing {
    std::string name;
    collage::Mask mask;
};
// A disc, a ring, a star, an L, a leaf, a hollow triangle, a letter T, and separate discs.
std::vector<Drawing> all(int side);

// The maps moved and scaled so that their attractor fits into the picture: its longer side is 0.9 units.
std::vector<ifs::AffineMap<2>> fitted(std::span<const ifs::AffineMap<2>> maps,
                                      std::span<const double> probabilities);
// The pixels that the chaos game hits, of the plane of a picture of that many pixels in each direction.
collage::Mask chaosGame(std::span<const ifs::AffineMap<2>> maps, std::span<const double> probabilities,
                        int side, int points);

} // namespace drawings
