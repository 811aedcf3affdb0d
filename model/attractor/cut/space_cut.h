// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/cloud_kernels.h"
#include "attractor/request/colour_coordinates.h"
#include "attractor/samples/prepared_space.h"
#include "attractor/solid/space_view.h"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace attractor {

// A word of a cut in space, and the bounding box of its image, in cells.
struct SpaceWord {
    kernels::CloudWord shown;
    float halfX = 0, halfY = 0;
    std::uint32_t firstMap = 0;   // index of the outermost map among the maps that take part
    std::uint32_t offset = 0;     // beginning of its run of samples; a function of the address alone
    double probability = 0;       // p_σ
    double addressCoordinate = 0; // palette coordinate: ColourCoordinates::middle()
};

// Words of the address tree that meet the view. From `firstExact` on, a perspective bends a word too much for
// its share of the samples, or the clip keeps a part of it only: they are taken through these maps, from box
// coordinates to those of SpaceView::toPixels, and projected one by one.
struct SpaceCut {
    std::vector<SpaceWord> words;
    std::size_t firstExact = 0;
    std::vector<ifs::AffineMap<3>> exact;
    bool isThinned = false; // true if words stand for others; another seed then chooses others
    double probability = 0; // Σ p_σ
};

enum class Exactness {
    WhereNeeded,
    All, // one by one for every word, because depths are needed
};

struct SpaceCutSettings {
    int words = 1024;   // each word has at most 1/words of the measure in view
    int minDepth = 0;   // least length of a word, so that its first maps are known
    double samples = 0; // number of samples in view; words with fewer than 32 are not divided for their bend
    Exactness exactness = Exactness::WhereNeeded;
    std::uint64_t seed = 1;      // choice of the words that stand for others, if there are too many
    ColourCoordinates colours{}; // empty: colours along the address
};

// The size of the view is counted in cells. Empty when stopped.
SpaceCut spaceCut(const PreparedSpace& system, const SpaceView& view, const SpaceCutSettings& settings,
                  const std::stop_token& stop = {});

} // namespace attractor
