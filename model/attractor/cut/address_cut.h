// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cut/bend_table.h"
#include "attractor/kernels/word.h"
#include "attractor/request/camera.h"
#include "attractor/request/colour_coordinates.h"
#include "attractor/samples/prepared_system.h"
#include "ifs/cage/control_cage.h"

#include <cmath>
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
    ifs::Matrix<2> scale = ifs::Matrix<2>::Identity(); // world units → cells, with y direction and rotation
    ifs::Placement cage;
    ifs::Vector<2> centre = ifs::Vector<2>::Zero(); // world point shown in the middle
    GridSize grid;
    int cellsPerPixel = 1;

    double cellsPerUnit() const { return std::hypot(scale(0, 0), scale(1, 0)); }
    // A coordinate of a world offset in cells. Skips zero coefficients, because 0 · ∞ is NaN.
    template <class Real> Real scaled(int row, const Real& x, const Real& y) const {
        return combined(scale(row, 0), scale(row, 1), x, y);
    }
    ifs::Vector<2> cell(const ifs::Vector<2>& displayed) const {
        const ifs::Vector<2> offset = displayed - centre;
        return {scaled(0, offset.x(), offset.y()) + grid.width / 2.0,
                scaled(1, offset.x(), offset.y()) + grid.height / 2.0};
    }
    // Half extents in cells of the bounding box of a world box with half extents `half`.
    ifs::Vector<2> boxAround(const ifs::Vector<2>& half) const {
        const auto row = [&](int i) {
            return combined(std::abs(scale(i, 0)), std::abs(scale(i, 1)), half.x(), half.y());
        };
        return {row(0), row(1)};
    }

private:
    template <class Real> static Real combined(double a, double b, const Real& x, const Real& y) {
        if (b == 0) return Real(a) * x;
        if (a == 0) return Real(b) * y;
        return Real(a) * x + Real(b) * y;
    }
};
Projection projection(const Camera& camera, const ifs::Placement& cage, int cellsPerPixel);

// Largest error of a word of a cage that bends.
constexpr double maxBendError = 0.25; // pixels

struct CutSettings {
    int words = 1024;                // each word has at most 1/words of the measure in view
    int minDepth = 0;                // least length of a word, so that its first maps are known
    int maxDepth = 1 << 30;          // greatest length of a word
    std::uint64_t seed = 1;          // choice of the words that stand for others, if there are too many
    std::size_t maxLooks = 1U << 25; // most words examined; open words then stay as they are
    // Number of samples in view; bends and blends are not followed into words with fewer than 32.
    double samples = 0;
    ColourCoordinates colours{};   // empty: colours along the address
    bool mergesCoinciding = false; // merges words of equal maps, if no colour tells them apart
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
    const Curve* curveOf(std::size_t word) const { // nullptr if the word has none
        return word >= firstCurved && word < firstExact ? &curves[word - firstCurved] : nullptr;
    }
    // For words before firstExact.
    ShownWord shown(std::size_t word) const { return {words[word], curveOf(word)}; }
    // The number of the sample set that each word of linked maps shows (PreparedSystem::sampleSetOf); empty
    // without links.
    std::vector<std::uint32_t> sampleSets;
    std::uint32_t sampleSet(std::size_t word) const { return sampleSets.empty() ? 0 : sampleSets[word]; }
    bool isThinned = false; // true if words stand for others; another seed then chooses others
    double probability = 0; // Σ p_σ: unbiased estimate of the measure of the words that meet the view
};

// Memory and expansions of a bending cage that one cut leaves to the next. It saves time and never changes a
// word.
struct CutMemory {
    BendTable bends;
    std::vector<ifs::AffineMap<2>> bent; // maps of the system that `bends` belongs to
    std::pmr::unsynchronized_pool_resource nodes{std::pmr::pool_options{1, 1U << 22}};
};

// The cut; empty when stopped.
AddressCut addressCut(const PreparedSystem& system, const Projection& projection, const CutSettings& settings,
                      std::stop_token stop = {}, CutMemory* kept = nullptr);

} // namespace attractor
