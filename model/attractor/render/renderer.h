// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/frame.h"
#include "attractor/request/render_request.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

// pixel = camera · cage · w_σ · sample
namespace attractor {

// A picture in the making: each pass adds request.samples samples with streams of its own and converges to
// the invariant measure. Algorithm::ChaosGame is finished when it has plotted request.samples points,
// Algorithm::Deterministic after one pass. Not thread-safe; owns its worker threads.
class Rendering {
public:
    explicit Rendering(RenderRequest request);
    void restart(RenderRequest request); // resets everything, but reuses memory and threads
    ~Rendering();
    Rendering(Rendering&&) noexcept;
    Rendering& operator=(Rendering&&) noexcept;

    // Draws one more pass of `samples` samples (0: request.samples). Returns false when stopped, within
    // milliseconds; the next refine() or frame() makes up for the rest of that pass.
    bool refine(std::stop_token stop = {}, std::uint64_t samples = 0);
    bool finished() const; // true when further passes gain nothing
    // The exposure that frame() uses: the one kept by the request, else that of the picture.
    Exposure exposure(std::stop_token stop = {}) const;
    // Tone-mapped picture of all samples so far, at its own exposure or at another. The memory of `reuse`, a
    // frame no longer needed, serves again. When stopped, within milliseconds, the pixels are invalid.
    Frame frame(Frame reuse = {}, std::stop_token stop = {},
                const std::optional<Exposure>& other = std::nullopt) const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

// Draws one pass synchronously; for export, the command line and tests.
Frame render(const RenderRequest& request);

} // namespace attractor
