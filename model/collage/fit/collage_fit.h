// SPDX-License-Identifier: MIT
#pragma once

#include "collage/fit/map_fit.h"
#include "collage/target/target.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

// The iterative closest point method for collages. docs/mathematics.md, "Collages".
namespace collage {

struct FitSchedule {
    Constraints constraints;
    int iterations = 40;
    int cautious = 15; // first iterations, in which cautiousNorm bounds the norms
    double cautiousNorm = 0.75;
    double maxNorm = 0.9; // bound of the norms in the others
};

// Moves maps so that the images of a target cover it and nothing else. One per thread, because it holds its
// working memory. The target must outlive it.
class CollageFit {
public:
    explicit CollageFit(const Target& target);

    // Maps in grid coordinates. Those with `locked` stay bit for bit; an empty span locks none. A stop ends
    // it between two iterations.
    void improve(std::vector<ifs::AffineMap<2>>& maps, const FitSchedule& schedule,
                 std::span<const std::uint8_t> locked = {}, const std::stop_token& stop = {});

    // The mean distance, in cells, from the target to its images and from these to the target, both counted
    // half. Images beyond the grid count as if they were on its edge.
    double error(std::span<const ifs::AffineMap<2>> maps);

    // Shares of the target that are nearest to the image of each map, sum 1; of the last call of one of the
    // functions above.
    std::vector<double> shares() const;

private:
    void place(std::span<const ifs::AffineMap<2>> maps);
    void placeImages(const ifs::AffineMap<2>& map, std::size_t index);
    void pullImages(const ifs::AffineMap<2>& map, std::size_t index, PairSums& sums) const;
    void coverTarget(std::vector<PairSums>& sums) const;

    const Target& m_target;
    Eigen::Matrix3d m_moments; // moments of the target's centres, with 1 appended
    ifs::Vector<2> m_across;   // unit vector across the target if it is a thin line, else 0
    // Label of each cell: 1 + map · points + point that has its image there; 0: none.
    std::vector<std::int32_t> m_labels;
    std::vector<std::int32_t> m_images; // cell of the image of each point under each map
    std::vector<float> m_distance;      // distance of each cell to the target
    NearestCells m_nearest;
};

} // namespace collage
