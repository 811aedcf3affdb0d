// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/bend_table.h"
#include "attractor/camera.h"
#include "attractor/drawable_system.h"
#include "ifs/control_cage.h"

#include <cstdint>
#include <memory_resource>
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
    ifs::Placement cage;
    ifs::Vector<2> centre = ifs::Vector<2>::Zero(); // world point shown in the middle
    GridSize grid;
    int cellsPerPixel = 1;

    ifs::Vector<2> cell(const ifs::Vector<2>& displayed) const {
        const ifs::Vector<2> offset = displayed - centre;
        return {scale(0, 0) * offset.x() + grid.width / 2.0, scale(1, 1) * offset.y() + grid.height / 2.0};
    }
};
Projection projection(const Camera& camera, const ifs::Placement& cage, int cellsPerPixel);

// How far a word of a cage that bends may be off.
constexpr double mostBendError = 0.25; // pixels

// One word of a cut: camera·cage·w_σ as a map from box coordinates to cells. Of a cage that bends, its
// first-order map.
struct Word {
    float xx = 0, xy = 0, yx = 0, yy = 0, x = 0, y = 0;
    std::uint32_t firstMap = 0;   // outermost, among the maps that take part
    std::uint32_t offset = 0;     // where its run of samples begins; depends on the address alone
    double probability = 0;       // p_σ
    double addressCoordinate = 0; // middle of the interval Σ σ_k N^−k … + N^−|σ|
};

// What a word has beside its affine map when the cage bends it by more: terms of second order, in cells.
struct Curve {
    float xaa = 0, xab = 0, xbb = 0, yaa = 0, yab = 0, ybb = 0; // of a², ab, b² for box coordinates (a, b)
};

struct CutSettings {
    int words = 1024;                 // no word has more than 1/words of the measure in view
    int minDepth = 0;                 // no word is shorter, so that its first maps are known
    int maxDepth = 1 << 30;           // no word is longer
    std::uint64_t seed = 1;           // decides which words stand for others where there are too many
    std::size_t mostLooks = 1U << 25; // words looked at; then those that are open stay as they are
    double samples = 0; // in view; a bend is not followed into words that would get fewer than 32
};

// Words of the address tree that meet the grid: A ∩ view = ∪ w_σ(A) ∩ view.
struct AddressCut {
    std::vector<Word> words;
    // The words from `firstCurved` to before `firstExact` have these curves. From `firstExact` on, samples
    // are taken through these maps from box coordinates to the code's, and then through the cage one by one.
    std::size_t firstCurved = 0;
    std::vector<Curve> curves;
    std::size_t firstExact = 0;
    std::vector<ifs::AffineMap<2>> exact;
    const Curve* curveOf(std::size_t word) const { // nullptr where there is none
        return word >= firstCurved && word < firstExact ? &curves[word - firstCurved] : nullptr;
    }
    bool isThinned = false; // words stand for others; another seed chooses others
    double probability = 0; // Σ p_σ: an unbiased estimate of the measure of the words that meet the view
};

// What one cut can leave to the next: memory, and what is known of a cage that bends. Never changes a word.
struct CutMemory {
    BendTable bends;
    std::pmr::unsynchronized_pool_resource nodes{std::pmr::pool_options{1, 1U << 22}};
};

// Empty when stopped.
AddressCut addressCut(const DrawableSystem& system, const Projection& projection, const CutSettings& settings,
                      std::stop_token stop = {}, CutMemory* kept = nullptr);

} // namespace attractor
