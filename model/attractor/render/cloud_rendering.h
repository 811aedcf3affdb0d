// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cells/cell_sums.h"
#include "attractor/folds/picture_part.h"
#include "attractor/light/tone_map16.h"
#include "attractor/request/space_request.h"

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace attractor {

// The density of the invariant measure in space under a camera, as Rendering draws it in the plane: each pass
// adds samples with streams of its own. Not thread-safe; owns its worker threads.
class CloudRendering {
public:
    explicit CloudRendering(SpaceRequest request);
    ~CloudRendering();
    CloudRendering(CloudRendering&&) noexcept;
    CloudRendering& operator=(CloudRendering&&) noexcept;

    void restart(SpaceRequest request); // resets everything, but reuses memory and threads

    // Goes on with a request that differs in system, cage and camera only: new samples add to those drawn
    // before.
    void follow(SpaceRequest request);

    // Draws one more pass of `samples` samples (0: request.samples). Returns false when stopped, within
    // milliseconds; then the picture is invalid until restart(). After follow(), the pass has as many samples
    // as show the attractor as densely as the first pass did.
    bool refine(const std::stop_token& stop = {}, std::uint64_t samples = 0);

    // Restricts counting to the units of the part, from the next pass on. samples() and the exposure remain
    // those of the whole picture. restart() makes it whole again.
    void setPart(const PicturePart& part);
    // Total number of units in passes of these sizes.
    static std::uint64_t units(std::span<const std::uint64_t> samples);
    // Restricts counting to pixel rows [firstRow, endRow), which leaves sums() of them and no picture. Call
    // after restart(), before the first pass.
    void keepRows(int firstRow, int endRow);
    CellSums& sums(); // counts of other parts can be added

    // The exposure kept by the request, else that of the picture.
    Exposure exposure(const std::stop_token& stop = {}) const;
    void useExposure(const Exposure& exposure); // exposure until the next pass, including the mean density
    // The picture so far, size.width × size.height pixels, as in Frame::pixels or with 16 bits per channel.
    // False when stopped.
    bool tone(std::span<std::uint32_t> pixels, const std::stop_token& stop = {}) const;
    bool tone(std::span<Rgba16> pixels, const std::stop_token& stop = {}) const;

    std::uint64_t samples() const; // samples drawn so far
    RenderNote note() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace attractor
