// SPDX-License-Identifier: MIT
#include "attractor/cell_sums.h"

#include <algorithm>

namespace attractor {

void CellSums::reset(CellKind kind, const CellWindow& window, std::size_t threads) {
    m_kind = kind;
    m_window = window;
    m_counts.resize(kind == CellKind::Count ? threads : 0);
    m_colours.resize(kind == CellKind::Colour ? threads : 0);
    const std::size_t size = window.cells() + trashCells;
    for (auto& counts : m_counts)
        counts.assign(size, 0);
    for (auto& colours : m_colours)
        colours.assign(size, ColourCell{});
    m_carriedCounts = {};
    m_carriedColours.clear();
    m_carriedColours.resize(m_colours.size());
}

void CellSums::carryOverColours(std::size_t thread) {
    std::vector<Sum>& carried = m_carriedColours[thread];
    carried.resize(m_window.cells());
    for (std::size_t i = 0; i < carried.size(); ++i) {
        const ColourCell& cell = m_colours[thread][i];
        carried[i].samples += cell.samples;
        carried[i].red += cell.red;
        carried[i].green += cell.green;
        carried[i].blue += cell.blue;
    }
    std::fill(m_colours[thread].begin(), m_colours[thread].end(), ColourCell{});
}

void CellSums::carryOverCounts() {
    m_carriedCounts.resize(m_window.cells());
    for (auto& counts : m_counts) {
        for (std::size_t i = 0; i < m_carriedCounts.size(); ++i)
            m_carriedCounts[i] += counts[i];
        std::fill(counts.begin(), counts.end(), 0U);
    }
}

std::vector<const std::uint32_t*> CellSums::counters() const {
    std::vector<const std::uint32_t*> result;
    for (const auto& counts : m_counts)
        result.push_back(counts.data());
    return result;
}

std::uint64_t CellSums::samples(std::size_t cell) const {
    if (m_kind == CellKind::Colour) return sum(cell).samples;
    std::uint64_t result = m_carriedCounts.empty() ? 0 : m_carriedCounts[cell];
    for (const auto& counts : m_counts)
        result += counts[cell];
    return result;
}

CellSums::Sum CellSums::sum(std::size_t cell) const {
    Sum result;
    for (const auto& colours : m_colours) {
        result.samples += colours[cell].samples;
        result.red += colours[cell].red;
        result.green += colours[cell].green;
        result.blue += colours[cell].blue;
    }
    for (const auto& carried : m_carriedColours) {
        if (carried.empty()) continue;
        result.samples += carried[cell].samples;
        result.red += carried[cell].red;
        result.green += carried[cell].green;
        result.blue += carried[cell].blue;
    }
    return result;
}

} // namespace attractor
