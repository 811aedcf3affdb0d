// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/camera.h"
#include "attractor/drawable_system.h"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace attractor {

// A rectangle of square cells that counts samples; cell (0, 0) at the top left.
struct GridSize {
    int width = 0;
    int height = 0;
};

// camera · cage: world coordinates of the code → cells. Kept in parts, because far inside the attractor the
// offset from the camera's centre has to be formed before it is scaled.
struct Projection {
    ifs::Matrix<2> scale = ifs::Matrix<2>::Identity(); // world units → cells, with the y direction
    ifs::AffineMap<2> cage;
    ifs::Vector<2> centre = ifs::Vector<2>::Zero(); // world point shown in the middle
    GridSize grid;
};
Projection projection(const Camera& camera, const ifs::AffineMap<2>& cage, int cellsPerPixel);

// One word of a cut: camera·cage·w_σ as a map from box coordinates to cells.
struct Word {
    float xx = 0, xy = 0, yx = 0, yy = 0, x = 0, y = 0;
    std::uint32_t firstMap = 0;   // outermost, among the maps that take part
    std::uint32_t offset = 0;     // where its run of samples begins; depends on the address alone
    double probability = 0;       // p_σ
    double addressCoordinate = 0; // middle of the interval Σ σ_k N^−k … + N^−|σ|
};

struct CutSettings {
    int words = 1024;       // no word has more than 1/words of the measure in view
    int minDepth = 0;       // no word is shorter, so that its first maps are known
    int maxDepth = 1 << 30; // no word is longer
    std::uint64_t seed = 1; // decides which words stand for others where there are too many
};

// Words of the address tree that meet the grid: A ∩ view = ∪ w_σ(A) ∩ view.
struct AddressCut {
    std::vector<Word> words;
    double probability = 0; // Σ p_σ: an unbiased estimate of the measure of the words that meet the view
};

// Empty when stopped.
AddressCut addressCut(const DrawableSystem& system, const Projection& projection, const CutSettings& settings,
                      std::stop_token stop = {});

} // namespace attractor
