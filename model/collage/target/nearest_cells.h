// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/mask.h"

#include <cstdint>
#include <vector>

// Exact Euclidean feature transforms: the nearest cell of a shape, from cell centre to cell centre.
namespace collage {

// The nearest set cell for every cell of a mask, as y · width + x, and the square of its distance in cells;
// −1 and maxSquare when none is set. Lower envelopes of parabolas (Felzenszwalb and Huttenlocher 2012),
// O(cells).
struct FeatureTransform {
    std::vector<std::int32_t> nearest;
    std::vector<std::int32_t> square;
};
constexpr std::int32_t maxSquare = INT32_MAX;
FeatureTransform featureTransform(const Mask& mask);

// Answers the same question for few cells, or near ones. It prepares only the columns; a query costs as many
// steps as the nearest cell is far. At most 32,000 rows.
class NearestCells {
public:
    // Cells whose label is not 0 are set. The vector must outlive the queries, unchanged.
    void prepare(const std::vector<std::int32_t>& labels, int width, int height);

    struct Found {
        std::int32_t cell = -1;
        std::int32_t square = maxSquare;
    };
    Found operator()(int x, int y) const;

private:
    int m_width = 0;
    int m_height = 0;
    std::vector<std::int16_t> m_above; // distance from each cell up to the nearest set cell of its column
    std::vector<std::int16_t> m_below;
};

} // namespace collage
