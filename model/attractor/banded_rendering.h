// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/renderer.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace attractor {

// A picture of any size, a few rows at a time: every band has the cut, the streams and the exposure of the
// whole picture, so that bands show no seams. Memory is that of one band. request.samples should grow with
// the size. Not thread-safe; owns its worker threads.
class BandedRendering {
public:
    explicit BandedRendering(RenderRequest request);
    ~BandedRendering();
    BandedRendering(BandedRendering&&) noexcept;
    BandedRendering& operator=(BandedRendering&&) noexcept;

    // How many rows of pixels fit into so many bytes with their cells; at least 1, at most all.
    int rowsWithin(std::size_t bytes) const;
    // Rows [firstRow, firstRow + rows) as in Frame::pixels; nullopt when stopped. Any order, any heights. The
    // first call measures the exposure of the whole picture and takes longer.
    std::optional<std::vector<std::uint32_t>> band(int firstRow, int rows, std::stop_token stop = {});
    Exposure exposure() const; // after the first band
    RenderNote note() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace attractor
