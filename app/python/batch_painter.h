// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/word.h"
#include "attractor/samples/chaos_game.h"
#include "ifs/system/affine_map.h"

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace python {

// Counts the points of one system after another in pictures of one size, as fast as a training set needs it:
// no certified box, no cut and no strata. The points themselves say where they lie.
class BatchPainter {
public:
    BatchPainter(int height, int width, std::uint64_t samples);

    // `counts` are height·width zeros, rows from the top. The same bits whatever the instruction set.
    // Stopped, it leaves some of them.
    void paint(const std::vector<ifs::AffineMap<2>>& maps, std::vector<double> probabilities,
               std::uint64_t seed, const std::stop_token& stop, std::uint32_t* counts);

private:
    // Points that are drawn at once, beginning at a multiple of `most`; they stay in the cache.
    attractor::PointExtremes draw(const attractor::PreparedSystem& system, std::uint64_t seed,
                                  std::uint64_t first);
    std::size_t sizeOf(std::uint64_t first) const;
    attractor::Word placed(const attractor::PreparedSystem& system,
                           const attractor::PointExtremes& extremes) const;

    int m_height;
    int m_width;
    std::uint64_t m_samples;
    std::vector<float> m_x, m_y;
};

} // namespace python
