// SPDX-License-Identifier: MIT
#pragma once

#include "collage/fit/map_fit.h"
#include "collage/measure/agreement.h"
#include "collage/target/mask.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

// Systems whose attractors look like a picture. docs/mathematics.md, "Collages".
namespace collage {

struct SearchOptions {
    int minMaps = 2;
    int maxMaps = 8;
    Constraints constraints;
    std::uint64_t seed = 0;
    std::size_t starts = 0; // number of starts; 0: as many as fit into the time
    std::chrono::duration<double> time{2};
    int threads = 1;
    std::size_t maxResults = 6;
};

struct Suggestion {
    std::vector<ifs::AffineMap<2>> maps;
    std::vector<double> weights; // share of the target that each map covers, at least 1 %; sum 1
    CollageMeasure collage;      // in pixels of the mask
    Agreement attractor;         // lengths in pixels of the mask
};

struct Suggestions {
    std::vector<Suggestion> list; // best first; empty when stopped
    std::size_t starts = 0;       // number of starts made
};

// Fits collages from many random starts, makes the attractors of the best distinct ones fit better, and lists
// them by the visibleError() of their attractors; each map counts a little, so that with a range of numbers
// of maps each must pay for itself. The same seed and the same number of starts give the same result for any
// number of threads; the time decides only how many starts are made. `progress` receives shares of the work,
// on the thread that calls. The mask must not be empty.
Suggestions suggestions(const Mask& picture, const SearchOptions& options,
                        const std::function<void(double)>& progress = {}, const std::stop_token& stop = {});

// Returns true if two systems are nearly the same: the optimal transport of the maps of one to those of the
// other costs little compared with the size of the target.
bool isAlike(const Suggestion& a, const Suggestion& b, double size);

} // namespace collage
