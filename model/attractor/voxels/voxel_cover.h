// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/samples/prepared_space.h"
#include "attractor/voxels/voxel_grid.h"

#include <cstdint>
#include <functional>
#include <stop_token>

namespace attractor {

// The set to cover: the image of a certified attractor, its branches moved, by an affine map.
struct VoxelRequest {
    const PreparedSpace& system; // isCertified
    ifs::AffineMap<3> placement; // the code's coordinates → those of the voxels
    ifs::Vector<3> min;          // a box that holds the image
    ifs::Vector<3> max;
    double side = 1; // of a voxel, > 0
    int margin = 0;  // voxels that are free on every side besides one
};

// A ⊂ V ⊂ A + √3 (side + fineness·side): V are the voxels that the boxes of words meet, where a word is taken
// apart until it lies in one voxel or its box is `fineness` of a voxel wide. The same voxels in whatever
// order the words come. docs/mathematics.md, "Voxels".
struct VoxelCover {
    static constexpr double fineness = 0.125;
    static constexpr std::uint64_t maxWords = 400'000'000; // some ten seconds

    enum class Outcome { Done, Stopped, TooManyVoxels, TooManyWords };

    Outcome outcome = Outcome::Done;
    VoxelGrid grid;
    ifs::Vector<3> origin = ifs::Vector<3>::Zero(); // lower corner of voxel (0, 0, 0)
    double side = 1;
    std::uint64_t words = 0; // looked at
};
bool fitsGrid(const VoxelRequest& request); // else there would be too many voxels; takes no time
VoxelCover voxelCover(const VoxelRequest& request, const std::function<void(double)>& progress = {},
                      const std::stop_token& stop = {});

} // namespace attractor
