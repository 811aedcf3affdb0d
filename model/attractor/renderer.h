// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/appearance.h"
#include "attractor/camera.h"
#include "ifs/branch.h"
#include "ifs/control_cage.h"
#include "ifs/iterated_function_system.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

// pixel = camera · cage · w_σ · sample
namespace attractor {

enum class Algorithm {
    Density,       // instanced samples of the invariant measure, refined without end
    ChaosGame,     // the paper's: exactly `samples` points are plotted, after 14 that are not
    Deterministic, // Wⁿ(rest cage), filled, n = iterations
};

// What fixes the meaning of brightness: kept from frame to frame during a drag so that nothing flickers.
struct Exposure {
    double meanDensity = 0; // of the occupied pixels of the view
    double whitePoint = 0;  // ρ_w, relative to that mean
    double gain = 1;        // of light, for what supersampling takes from sets thinner than a pixel

    friend bool operator==(const Exposure&, const Exposure&) = default;
};

// An immutable job. Same request (revision and threads apart) ⇒ same pixels.
struct RenderRequest {
    std::uint64_t revision = 0; // handed through to the frame
    ifs::IteratedFunctionSystem<2> system;
    std::optional<ifs::ControlCage<2>> cage; // nullopt: the code is drawn as it is
    std::vector<ifs::MovedBranch<2>> moved;  // before the cage; words over places in the system
    Appearance appearance;
    Camera camera;
    Algorithm algorithm = Algorithm::Density;
    std::uint64_t samples = 10'000'000; // Density: samples in one pass, all spent on words that meet the view
    std::uint64_t seed = 1;
    int iterations = 0; // Deterministic
    int threads = 1;    // ≥ 1; never changes a pixel
    // White point and gain of an earlier frame, to be kept (during a drag, in an export). The mean density is
    // that of this picture always, so that neither zoom nor the placement changes its brightness.
    std::optional<Exposure> exposure;
};

// Why a picture may not show what the user expects. The sentence for the user is the view's.
enum class RenderNote {
    None,
    NoMaps,          // no map takes part: an empty picture
    NoAttractor,     // some word expands; points that leave a huge range are dropped
    Undecided,       // existence not settled; drawn with the same guard
    TooDeep,         // zoomed beyond the resolution of the arithmetic
    Degenerate,      // the picture is flat in this placement
    FewerIterations, // Deterministic: fewer than asked for, Frame::iterations says how many
};

// An immutable result.
struct Frame {
    std::uint64_t revision = 0;
    Camera camera;
    // 0xAARRGGBB, premultiplied, rows from the top, camera.width × camera.height
    std::vector<std::uint32_t> pixels;
    bool opaque = false;       // every pixel has alpha 255
    std::uint64_t samples = 0; // accumulated so far
    double measure = 0;        // of the words that meet the view, estimated; 1 when all of the attractor does
    int passes = 0;
    int iterations = 0; // Deterministic: drawn
    Exposure exposure;  // that of the request, else of this picture
    Exposure shown;     // in the pixels: another one while brightness eases
    RenderNote note = RenderNote::None;
    double milliseconds = 0; // time the last pass took
};

// A picture in the making: each pass adds request.samples samples with streams of its own and converges to
// the invariant measure. Algorithm::ChaosGame is finished when it has plotted request.samples points,
// Algorithm::Deterministic after one pass. Not thread-safe; owns its worker threads.
class Rendering {
public:
    explicit Rendering(RenderRequest request);
    void restart(RenderRequest request); // as if new, with the memory and the threads there are
    ~Rendering();
    Rendering(Rendering&&) noexcept;
    Rendering& operator=(Rendering&&) noexcept;

    // One more pass of `samples` samples (0: request.samples). Returns false when stopped, within
    // milliseconds; the rest of that pass is made up for by the next refine() or frame().
    bool refine(std::stop_token stop = {}, std::uint64_t samples = 0);
    bool finished() const; // nothing more to gain
    // What frame() shows by itself: the exposure kept by the request, else that of the picture.
    Exposure exposure(std::stop_token stop = {}) const;
    // Tone-mapped picture of what has been accumulated, at its own exposure or at another. The memory of
    // `reuse`, a frame no longer needed, serves again. When stopped, within milliseconds, the pixels are
    // worth nothing.
    Frame frame(Frame reuse = {}, std::stop_token stop = {},
                const std::optional<Exposure>& other = std::nullopt) const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

// One pass, synchronous. What export, the command line and the tests call.
Frame render(const RenderRequest& request);

} // namespace attractor
