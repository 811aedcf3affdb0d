// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"
#include "attractor/request/orbit_camera.h"
#include "attractor/request/render_request.h"
#include "ifs/cage/control_cage.h"
#include "ifs/system/iterated_function_system.h"

#include <cstdint>
#include <optional>

namespace attractor {

// An immutable job in space. Same request (revision and threads apart) ⇒ same bytes.
struct SpaceRequest {
    std::uint64_t revision = 0; // handed through
    ifs::IteratedFunctionSystem<3> system;
    std::optional<ifs::ControlCage<3>> cage; // nullopt, or not valid: the code is drawn as it is
    OrbitCamera camera;
    int threads = 1; // ≥ 1; never changes a byte
    // Of a density:
    Appearance appearance;
    std::uint64_t samples = 10'000'000; // in one pass, all spent on words that meet the view
    std::uint64_t seed = 1;
    std::optional<Exposure> exposure; // of an earlier frame, to be kept
};

} // namespace attractor
