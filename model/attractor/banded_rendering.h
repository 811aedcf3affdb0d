// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/renderer.h"
#include "attractor/tone_map16.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>

namespace attractor {

// A picture of any size, a few rows at a time: every band has the cut, the streams and the exposure of the
// whole picture, so that bands show no seams. Memory is that of one band. request.samples should grow with
// the size. Not thread-safe; owns its worker threads.
class BandedRendering {
public:
    using Progress = std::function<void(double fraction)>; // of one call, 0 … 1

    explicit BandedRendering(RenderRequest request);
    ~BandedRendering();
    BandedRendering(BandedRendering&&) noexcept;
    BandedRendering& operator=(BandedRendering&&) noexcept;

    // Memory for the cells of one row of pixels, in bytes.
    static std::size_t bytesPerRow(const RenderRequest& request);
    // How many rows of pixels have cells that fit into so many bytes; at least 1, at most all.
    static int rowsWithin(const RenderRequest& request, std::size_t bytes);

    // Rows [firstRow, firstRow + rows) into `pixels`, rows × camera.width of them: as in Frame::pixels, or
    // with 16 bits a channel. Any order, any heights; the first call measures the exposure of the whole
    // picture and takes longer. False when stopped, within milliseconds.
    bool band(int firstRow, int rows, std::span<std::uint32_t> pixels, const std::stop_token& stop = {},
              const Progress& progress = {});
    bool band(int firstRow, int rows, std::span<Rgba16> pixels, const std::stop_token& stop = {},
              const Progress& progress = {});

    Exposure exposure() const; // after the first band
    RenderNote note() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace attractor
