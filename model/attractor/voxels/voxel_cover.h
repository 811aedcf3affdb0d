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
    const PreparedSpace& system; // must be certified: isCertified
    ifs::AffineMap<3> placement; // coordinates of the code → coordinates of the voxels
    ifs::Vector<3> min;          // lower corner of a box that holds the image
    ifs::Vector<3> max;
    double side = 1; // side of a voxel, > 0
    int margin = 0;  // free voxels on every side, in addition to one
};

// A ⊂ V ⊂ A + √3 (side + fineness·side): V are the voxels that the boxes of words meet, where a word is taken
// apart until it lies in one voxel or its box is `fineness` of a voxel wide. The same voxels in whatever
// order the words come. docs/mathematics.md, "Voxels".
struct VoxelCover {
    static constexpr double fineness = 0.125;
    static constexpr std::uint64_t maxWords = 400'000'000; // limit, reached after some ten seconds

    enum class Outcome { Done, Stopped, TooManyVoxels, TooManyWords };

    Outcome outcome = Outcome::Done;
    VoxelGrid grid;
    ifs::Vector<3> origin = ifs::Vector<3>::Zero(); // lower corner of voxel (0, 0, 0)
    double side = 1;
    std::uint64_t words = 0; // words examined
};
bool fitsGrid(const VoxelRequest& request); // false if there would be too many voxels; takes no time
VoxelCover voxelCover(const VoxelRequest& request, const std::function<void(double)>& progress = {},
                      const std::stop_token& stop = {});

} // namespace attractor
