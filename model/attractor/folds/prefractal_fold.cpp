// SPDX-License-Identifier: MIT
#include "attractor/folds/prefractal_fold.h"

#include "attractor/folds/prefractal.h"

namespace attractor {

void PrefractalFold::start(Workers& workers) {
    SumFold::start(workers);
    m_iterations = affordableIterations(prepared().system().maps.size(), prepared().request().iterations);
}

void PrefractalFold::rewind(const CellWindow& window) {
    SumFold::rewind(window);
    m_isDrawn = false;
}

RenderNote PrefractalFold::note() const {
    return m_iterations < prepared().request().iterations ? RenderNote::FewerIterations : RenderNote::None;
}

std::vector<ifs::Vector<2>> PrefractalFold::polygon() const {
    const auto& cage = prepared().request().cage;
    if (cage && ifs::isValid(*cage)) return cage->rest;
    const PreparedSystem& system = prepared().system();
    const ifs::Vector<2> low = system.centre - system.halfExtent;
    const ifs::Vector<2> high = system.centre + system.halfExtent;
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

bool PrefractalFold::complete(const std::stop_token& stop) {
    if (remaining() == 0) return true;
    sums().reset(sums().kind(), sums().window(), workers().size());
    const Prefractal job{prepared().system(), polygon(), m_iterations, prepared().coordinates()};
    const auto colour = [this](std::uint32_t map, double addressCoordinate) {
        return prepared().coloured() ? prepared().colourOf(map, addressCoordinate) : ColourCell{};
    };
    if (!job.draw(prepared().projection(), colour, sums(), stop)) return false;
    settle(remaining(), 0);
    m_isDrawn = true;
    return true;
}

// Pixels covered by a single image have density 1.
std::optional<Exposure> PrefractalFold::exposure(const std::stop_token&) {
    return Exposure{1, 16, 1};
}

double PrefractalFold::densityPerSample(const Exposure&) const {
    return 1;
}

} // namespace attractor
