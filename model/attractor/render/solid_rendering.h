// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/depth_raster.h"
#include "attractor/request/space_request.h"

#include <cstddef>
#include <memory>
#include <stop_token>

namespace attractor {

// A solid without noise: picture = fold(min, key(camera · cage · w_σ · cover)), words nearest first and those
// skipped that lie behind. Exact, and finished after one pass. Serves one request after the other with the
// memory there is, and keeps what it knows of a system that stays the same. Not thread-safe; owns its worker
// threads. docs/mathematics.md, "Solids".
class SolidRendering {
public:
    explicit SolidRendering(SpaceRequest request);
    ~SolidRendering();
    SolidRendering(SolidRendering&&) noexcept;
    SolidRendering& operator=(SolidRendering&&) noexcept;

    void restart(SpaceRequest request);

    // False when stopped, within milliseconds: then the raster is worth nothing until the next draw().
    bool draw(const std::stop_token& stop = {});
    // Draws rows [firstRow, endRow) only; the raster keeps them, and perhaps some more around them.
    bool drawRows(int firstRow, int endRow, const std::stop_token& stop = {});
    const DepthRaster& raster() const;
    DepthRaster takeRaster(); // leaves an empty raster

    // Why the picture may not show what the user expects: None, NoMaps, NoAttractor, Undecided, TooDeep or
    // Degenerate.
    RenderNote note() const;

    struct Work {
        std::size_t words = 0;  // words examined
        std::size_t points = 0; // points drawn
        bool isCoarse = false;  // true if pieces overlap so often that parts may be missing
    };
    Work work() const; // work of the last draw()

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace attractor
