// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"
#include "attractor/request/camera.h"
#include "ifs/cage/control_cage.h"
#include "ifs/names.h"
#include "ifs/system/affine_map.h"
#include "ifs/system/branch.h"
#include "ifs/system/iterated_function_system.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

// pixel = camera · cage · w_σ · sample
namespace attractor {

enum class Algorithm {
    Density,       // instanced samples of the invariant measure, refined without end
    ChaosGame,     // exactly `samples` plotted points, as in the paper, after 14 that are not plotted
    Deterministic, // Wⁿ(rest cage), filled; n = iterations
};

// Exposure: fixes the meaning of brightness. Kept from frame to frame during a drag so that nothing flickers.
struct Exposure {
    double meanDensity = 0; // mean over the occupied pixels of the view
    double whitePoint = 0;  // ρ_w relative to meanDensity
    double gain = 1;        // factor of light that makes up for supersampling of sets thinner than a pixel

    friend bool operator==(const Exposure&, const Exposure&) = default;
};

// An immutable job. Same request (revision and threads apart) ⇒ same pixels.
struct RenderRequest {
    std::uint64_t revision = 0; // copied to the frame
    ifs::IteratedFunctionSystem<2> system;
    std::optional<ifs::ControlCage<2>> cage; // nullopt: no placement
    std::vector<ifs::MovedBranch<2>> moved;  // changes before the cage; words over indices in the system
    Appearance appearance;
    // Takes the picture to its shadow, in world coordinates; nullopt: it has none. See shadowRequest().
    std::optional<ifs::AffineMap<2>> shadow;
    Camera camera;
    Algorithm algorithm = Algorithm::Density;
    std::uint64_t samples = 10'000'000; // Density: samples in one pass, all spent on words that meet the view
    std::uint64_t seed = 1;
    int iterations = 0; // Deterministic only
    int threads = 1;    // ≥ 1; no effect on pixels
    // White point and gain of an earlier frame, to be kept (during a drag, in an export). The mean density is
    // that of this picture always, so that neither zoom nor the placement changes its brightness.
    std::optional<Exposure> exposure;
};

// Why a picture may not show what the user expects. The sentence for the user is the view's.
enum class RenderNote {
    None,
    NoMaps,          // no map takes part: an empty picture
    NoAttractor,     // a word expands; points outside a huge range are dropped
    Undecided,       // existence not settled; points are dropped likewise
    TooDeep,         // zoomed beyond the resolution of the arithmetic
    TooFar,          // solids only: the farthest points may be drawn in the wrong order
    Degenerate,      // picture is flat in this placement
    FewerIterations, // Deterministic: fewer steps than requested; Frame::iterations is the number
};

} // namespace attractor

template <>
inline constexpr auto ifs::names<attractor::Algorithm> = std::to_array<ifs::Named<attractor::Algorithm>>({
    {attractor::Algorithm::Density, "density"},
    {attractor::Algorithm::ChaosGame, "chaos-game"},
    {attractor::Algorithm::Deterministic, "deterministic"},
});
