// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"
#include "attractor/request/orbit_camera.h"
#include "attractor/request/render_request.h"
#include "attractor/request/space_appearance.h"
#include "ifs/cage/control_cage.h"
#include "ifs/system/branch.h"
#include "ifs/system/iterated_function_system.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace attractor {

// Meaning of the lower bits of a solid's key.
enum class SolidKey {
    Map,     // first map of its address, modulo 256
    Address, // address coordinate in 256 steps
};

// Quantity that the colours of a density show.
enum class CloudColour {
    Appearance, // colours of the appearance
    MeanDepth,  // palette from the farthest depth to the nearest
};

// The eyes of a stereoscopic picture are this far to either side, in distances from the target.
constexpr double stereoEye = 1.0 / 60;

// An immutable job in space. Same request (revision and threads apart) ⇒ same bytes.
struct SpaceRequest {
    std::uint64_t revision = 0; // copied to the frame
    ifs::IteratedFunctionSystem<3> system;
    std::optional<ifs::ControlCage<3>> cage; // nullopt or invalid: no placement
    OrbitCamera camera;
    std::optional<SpaceClip> clip; // must be usable
    // Offset of the eye to the right of the camera's, in distances from the target; points in the plane of
    // the target keep their pixels. docs/mathematics.md, "Stereo".
    double eyeShift = 0;
    SolidKey key = SolidKey::Map; // solids only
    int threads = 1;              // ≥ 1; no effect on pixels
    // Settings for densities:
    CloudColour cloudColour = CloudColour::Appearance;
    Appearance appearance;
    std::uint64_t samples = 10'000'000; // samples of one pass, all spent on words that meet the view
    std::uint64_t seed = 1;
    std::optional<Exposure> exposure; // exposure of an earlier frame, to be kept

    std::vector<ifs::MovedBranch<3>> moved{}; // changes before the cage; words over indices in the system
};

} // namespace attractor
