// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/cage_surface.h"
#include "ifs/system/affine_map.h"

#include <array>
#include <cstddef>
#include <vector>

namespace attractor {

// A bent word with everything in it, expanded to second order: u ↦ middle + linear·u + (uᵀ second[r] u)/2 for
// every coordinate r, off by at most `miss` in [−1, 1]³.
struct BentWord {
    ifs::Vector<3> middle = ifs::Vector<3>::Zero();
    ifs::Matrix<3> linear = ifs::Matrix<3>::Zero();
    std::array<ifs::Matrix<3>, 3> second;
    ifs::Vector<3> miss = ifs::Vector<3>::Zero();
};

// A bend, and an affine map after it.
struct PixelBend {
    PixelBend() = default;
    PixelBend(const ifs::CageDeformation& bend, const ifs::AffineMap<3>& after);

    ifs::AffineMap<3> fit;
    std::vector<ifs::Vector<3>> residuals; // residuals of the vertices of the cage
};

// The coordinates of a cage at rest over a word, from its middle, the middles of its sides and its corners:
// for every vertex a polynomial of second order and its error. They do not depend on the moved cage.
class WordCoordinates {
public:
    WordCoordinates(const ifs::CageCoordinates& rest, const ifs::AffineMap<3>& word);

    BentWord bent(const ifs::AffineMap<3>& word, const PixelBend& bend) const; // bend of the same word
    static std::size_t bytes(std::size_t vertices) {
        return vertices * (straightTerms * sizeof(double) + bentTerms * sizeof(float));
    }

private:
    static constexpr std::size_t straightTerms = 4; // terms per vertex: 1 · x y z
    // x² y² z² · yz zx xy · what remains at the corners: 1 x y z xyz · a zero. Small, so that floats say
    // enough.
    static constexpr std::size_t bentTerms = 12;
    std::vector<double> m_straight;
    std::vector<float> m_bent;
};

} // namespace attractor
