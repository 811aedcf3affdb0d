// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/solid_walk.h"
#include "attractor/samples/prepared_space.h"
#include "attractor/solid/space_view.h"

#include <optional>
#include <span>
#include <vector>

namespace attractor {

// The one by which all maps shrink; nullopt where they do anything else.
std::optional<double> commonRatio(const PreparedSpace& system);

// Cover thinned for one direction of view. If all maps shrink by one ratio without turning anything, an
// orthographic camera sees all words of one length alike. These are the points of the cover that can be
// nearest in some pixel, wherever between the pixels the word lies: the others would lose in all of them.
// docs/mathematics.md, "Solids".
class FacingCover {
public:
    FacingCover() = default;
    // `covers` from the coarsest to the finest; empty where there is nothing to gain.
    FacingCover(const PreparedSpace& system, const SpaceView& view, std::span<const kernels::Cover> covers);

    bool isEmpty() const { return m_coordinates.empty(); }
    kernels::Cover cover() const; // valid only for words of the size it was made for

private:
    float m_spacing = 1;
    float m_size = 0; // size of the words in pixels
    std::size_t m_padded = 0;
    std::vector<float> m_coordinates; // x, y and z, nearest points first
};

} // namespace attractor
