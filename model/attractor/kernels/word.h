// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace attractor {

// A word of a cut: camera·cage·w_σ as a map from box coordinates to cells. If the cage bends, its first-order
// map.
struct Word {
    float xx = 0, xy = 0, yx = 0, yy = 0, x = 0, y = 0;
    std::uint32_t firstMap = 0;   // index of the outermost map among the maps that take part
    std::uint32_t offset = 0;     // beginning of its run of samples; a function of the address alone
    double probability = 0;       // p_σ
    double addressCoordinate = 0; // palette coordinate: ColourCoordinates::middle()
};

// Second-order terms of a word, in cells, for cages that bend it by more than an affine map can show.
struct Curve {
    float xaa = 0, xab = 0, xbb = 0, yaa = 0, yab = 0, ybb = 0; // factors of a², ab, b² in box coordinates
};

// A word with the curve that it may have. A view of both.
struct ShownWord {
    const Word& word;
    const Curve* curve = nullptr;

    ShownWord(const Word& w, const Curve* c = nullptr) : word(w), curve(c) {}
};

} // namespace attractor
