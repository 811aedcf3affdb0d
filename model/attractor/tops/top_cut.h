// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/tops/coupled_system.h"
#include "attractor/tops/word_tree.h"

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace attractor {

// A word of a cut.
struct TopWord {
    ifs::AffineMap<2> shown;  // coordinates of F → pixels
    std::uint32_t number = 0; // index in the tree
    double address = 0, step = 1;
    PixelBox box{};
};

// Words of the address tree of which no two begin alike, in the order of their addresses, that are at most
// `size` pixels large and meet the picture: the rank of a word is its index.
struct TopCut {
    std::vector<TopWord> words;
    WordTree tree; // tree of the words and their beginnings
    double size = 0;
};

// The finest cut, in steps of √2, of at most `maxWords` words; the empty word is always one.
TopCut topCut(const CoupledSystem& system, const Camera& camera, std::size_t maxWords,
              const std::stop_token& stop);

} // namespace attractor
