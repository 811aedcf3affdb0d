// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace attractor {

// A word of a cut: camera·cage·w_σ as a map from box coordinates to cells. If the cage bends, its first-order
// map.
struct Word {
    float xx = 0, xy = 0, yx = 0, yy = 0, x = 0, y = 0;
    std::uint32_t firstMap = 0;   // outermost, among the maps that take part
    std::uint32_t offset = 0;     // where its run of samples begins; depends on the address alone
    double probability = 0;       // p_σ
    double addressCoordinate = 0; // on the palette: ColourCoordinates::middle()
};

// Second-order terms of a word, in cells, for cages that bend it by more than an affine map can show.
struct Curve {
    float xaa = 0, xab = 0, xbb = 0, yaa = 0, yab = 0, ybb = 0; // of a², ab, b² for box coordinates (a, b)
};

// A word with the curve that it may have. A view of both.
struct ShownWord {
    const Word& word;
    const Curve* curve = nullptr;

    ShownWord(const Word& w, const Curve* c = nullptr) : word(w), curve(c) {}
};

} // namespace attractor
