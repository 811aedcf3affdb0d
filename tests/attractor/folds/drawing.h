// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/folds/sum_fold.h"

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace folds {

// A fold at work on a request.
template <class Fold> struct Drawing {
    attractor::PreparedRequest prepared;
    attractor::Workers workers;
    Fold fold{prepared};

    explicit Drawing(const attractor::RenderRequest& request)
        : workers(static_cast<std::size_t>(request.threads)) {
        prepared.set(request);
        fold.start(workers);
        rewind();
    }
    void rewind() { fold.rewind({prepared.request().camera.width, 0, prepared.request().camera.height}); }
    bool pass(std::uint64_t samples) {
        fold.begin(samples);
        return fold.complete({});
    }
    const attractor::CellSums& sums() const { return fold.sums(); }
};

// Of all cells of the window, row by row.
inline std::vector<std::uint64_t> countsOf(const attractor::CellSums& sums) {
    std::vector<std::uint64_t> result;
    std::vector<std::uint64_t> row;
    for (int y = 0; y < sums.window().endRow - sums.window().firstRow; ++y) {
        sums.samplesOfRow(y, row);
        result.insert(result.end(), row.begin(), row.end());
    }
    return result;
}

inline std::uint64_t totalOf(const attractor::CellSums& sums) {
    const std::vector<std::uint64_t> counts = countsOf(sums);
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

} // namespace folds
