// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cells/cell_sums.h"
#include "attractor/folds/picture_part.h"
#include "attractor/light/tone_map16.h"
#include "attractor/render/renderer.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace attractor {

// The share of a picture that is drawn here, when several machines or runs draw it together.
struct DividedPicture {
    struct Pass {
        std::uint64_t samples = 0; // samples of the whole pass
        PicturePart part;          // share drawn here; its units count from the first pass on
    };
    std::vector<Pass> passes;
    // Adds samples drawn elsewhere to rows of cells, those of the window. False when they are not available.
    std::function<bool(CellSums& sums)> others;
};

// A picture of any size, a few rows at a time: every band has the cut, the streams and the exposure of the
// whole picture, so that bands show no seams. Memory is that of one band. request.samples should grow with
// the size. Not thread-safe; owns its worker threads.
class BandedRendering {
public:
    using Progress = std::function<void(double fraction)>; // fraction of one call, 0 … 1

    explicit BandedRendering(RenderRequest request);
    ~BandedRendering();
    BandedRendering(BandedRendering&&) noexcept;
    BandedRendering& operator=(BandedRendering&&) noexcept;

    // Memory for the cells of one row of pixels, in bytes.
    static std::size_t bytesPerRow(const RenderRequest& request);
    // Number of rows of pixels whose cells fit into `bytes`; at least 1, at most all.
    static int rowsWithin(const RenderRequest& request, std::size_t bytes);

    // Rows [firstRow, firstRow + rows) into `pixels`, rows × camera.width of them: as in Frame::pixels, or
    // with 16 bits per channel. Any order, any heights; the first call measures the exposure of the whole
    // picture and takes longer. False when stopped, within milliseconds.
    bool band(int firstRow, int rows, std::span<std::uint32_t> pixels, const std::stop_token& stop = {},
              const Progress& progress = {});
    bool band(int firstRow, int rows, std::span<Rgba16> pixels, const std::stop_token& stop = {},
              const Progress& progress = {});

    // The picture consists of these passes, the first of request().samples, in place of one pass that is
    // drawn here; the exposure is that of the first. Call before the first band, for Algorithm::Density
    // alone.
    void divide(DividedPicture picture);
    // The picture is what a shutter sees, in place of one moment: the samples are shared out evenly over
    // these requests, which differ from request() in system, cage, moved branches and camera only, and add
    // up. The exposure is that of request(). Call before the first band, for Algorithm::Density alone, and
    // not with divide().
    void openShutter(std::vector<RenderRequest> moments);
    // Total number of units in passes of these sizes.
    std::uint64_t units(std::span<const std::uint64_t> samples) const;
    // The sums of rows [firstRow, firstRow + rows) of pixels, valid until the next call; nullptr when stopped
    // or the others' sums cannot be had.
    const CellSums* sums(int firstRow, int rows, const std::stop_token& stop = {},
                         const Progress& progress = {});

    Exposure exposure() const;                  // available after the first band
    void useExposure(const Exposure& exposure); // exposure for all bands, including the mean density
    // The exposure of the whole picture, before any band; nullopt when stopped.
    std::optional<Exposure> measuredExposure(const std::stop_token& stop = {});
    RenderNote note() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace attractor
