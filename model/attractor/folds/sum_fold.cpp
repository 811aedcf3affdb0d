// SPDX-License-Identifier: MIT
#include "attractor/folds/sum_fold.h"

#include <algorithm>
#include <atomic>

namespace attractor {

void SumFold::start(Workers& workers) {
    m_workers = &workers;
    m_exposure.reset();
}

void SumFold::rewind(const CellWindow& window) {
    m_sums.reset(m_prepared.coloured() ? CellKind::Colour : CellKind::Count, window, m_workers->size(),
                 layers());
    m_remaining = 0;
    m_drawn = 0;
    m_sinceCarry = 0;
}

void SumFold::settle(std::uint64_t samples, std::uint64_t drawn) {
    m_remaining -= samples;
    m_drawn += drawn;
}

void SumFold::makeRoomFor(std::uint64_t samples) {
    if ((m_prepared.coloured() && !m_sums.layered()) || m_sinceCarry + samples < std::uint64_t{1} << 32)
        return;
    m_sums.carryOverCounts();
    m_sinceCarry = 0;
}

std::optional<std::size_t> SumFold::cellOf(const ifs::Vector<2>& x) const {
    const Projection& projection = m_prepared.projection();
    const ifs::Vector<2> position = projection.cell(projection.cage(x));
    const CellWindow& window = m_sums.window();
    if (!(position.x() >= 0 && position.x() < window.width && position.y() >= window.firstRow &&
          position.y() < window.endRow))
        return std::nullopt;
    return static_cast<std::size_t>(static_cast<int>(position.y()) - window.firstRow) *
               static_cast<std::size_t>(window.width) +
           static_cast<std::size_t>(position.x());
}

void SumFold::plot(const ifs::Vector<2>& x, const ColourCell* colour, std::size_t thread) {
    const auto cell = cellOf(x);
    if (!cell) return;
    if (colour == nullptr) {
        ++m_sums.counts(thread)[*cell];
        return;
    }
    ColourCell& sum = m_sums.colours(thread)[*cell];
    sum.samples += 1;
    sum.red += colour->red;
    sum.green += colour->green;
    sum.blue += colour->blue;
    if ((sum.samples | sum.red | sum.green | sum.blue) >> 31 != 0) m_sums.carryOverColours(thread);
}

std::optional<Exposure> SumFold::exposure(const std::stop_token& stop) {
    if (m_exposure) return m_exposure;
    const RenderRequest& request = m_prepared.request();
    const Exposure measured = measuredExposure(m_sums, request.appearance, samplesOverAttractor(),
                                               request.exposure, *m_workers, stop);
    if (!stop.stop_requested()) m_exposure = measured;
    return m_exposure;
}

Occupancy SumFold::occupancy(double share) const {
    return attractor::occupancy(m_sums, m_prepared.cellsPerPixel(), share, *m_workers);
}

double SumFold::densityPerSample(const Exposure& exposure) const {
    const int side = m_prepared.cellsPerPixel();
    const double samples = samplesOverAttractor();
    return samples > 0 ? side * side / (samples * exposure.meanDensity) : 0;
}

ToneSettings SumFold::toneSettings(const Exposure& exposure) const {
    return {m_prepared.request().appearance, m_prepared.cellsPerPixel(), densityPerSample(exposure),
            exposure.whitePoint, exposure.gain};
}

template <class Tones, class Pixel>
bool SumFold::toneRows(const Tones& tones, std::span<Pixel> pixels, const std::stop_token& stop) const {
    constexpr int cellsTogether = 1 << 19; // cells between two checks of the stop token
    const int side = m_prepared.cellsPerPixel();
    const CellWindow& window = m_sums.window();
    const int rows = (window.endRow - window.firstRow) / side;
    const int together = std::clamp(cellsTogether / std::max(1, window.width * side), 1, 16);
    std::atomic<int> next = 0;
    m_workers->run([&](std::size_t) {
        while (!stop.stop_requested()) {
            const int row = next.fetch_add(together);
            if (row >= rows) return;
            tones.apply(m_sums, row, std::min(rows, row + together), pixels);
        }
    });
    return !stop.stop_requested();
}

bool SumFold::tone(const Exposure& exposure, std::span<std::uint32_t> pixels,
                   const std::stop_token& stop) const {
    return toneRows(ToneMap(toneSettings(exposure), maxInACell()), pixels, stop);
}

bool SumFold::tone(const Exposure& exposure, std::span<Rgba16> pixels, const std::stop_token& stop) const {
    return toneRows(ToneMap16(toneSettings(exposure)), pixels, stop);
}

} // namespace attractor
