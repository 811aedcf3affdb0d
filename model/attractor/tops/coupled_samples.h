// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/coupled_system.h"
#include "attractor/tops/word_tree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace attractor {

// Points of both attractors by the same maps, x_n = f_i(x_n−1) and y_n = g_i(y_n−1), in the order of their
// addresses, the top one first: the rank of a sample is its index.
struct CoupledSamples {
    static constexpr std::size_t usual = 4096; // samples of a word; more if there are few words
    static constexpr std::size_t maxPerWord = std::size_t{1} << 20;
    static constexpr std::size_t lanes = 16; // padding: arrays repeat the last point up to a multiple of this

    std::size_t size = 0;
    std::vector<float> x, y; // relative to `centre`, in units of `scale`
    ifs::Vector<2> centre;
    double scale = 1;
    struct Image {
        double x, y;    // point in G
        double address; // Σ σ_k N^−k
        // The stretch of the shortest beginning of the address whose piece is at most `pieceSize` times as
        // large as the attractor.
        double stretch;
    };
    std::vector<Image> images;

    // Recomputes everything that depends on G, after another one.
    void moveTo(const CoupledSystem& system);

    // Input of moveTo(): the steps in the order of the orbit, and the beginnings by rank.
    struct Step {
        std::uint32_t symbol, rank;
    };
    std::vector<Step> orbit;
    std::vector<std::uint32_t> beginnings;
    WordTree tree;
    std::vector<ifs::Matrix<2>> linear; // linear parts in F of the words of the tree
};

// `size` of at most CoupledSamples::maxPerWord samples, from the point that repeats the first map on.
CoupledSamples coupledSamples(const CoupledSystem& system, std::uint64_t seed, std::size_t size,
                              double pieceSize);

} // namespace attractor
