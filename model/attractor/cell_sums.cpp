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

void CellSums::samplesOfRow(int row, std::vector<std::uint64_t>& samples) const {
    const auto width = static_cast<std::size_t>(m_window.width);
    const std::size_t first = static_cast<std::size_t>(row) * width;
    samples.assign(width, 0);
    for (const auto& counts : m_counts)
        for (std::size_t x = 0; x < width; ++x)
            samples[x] += counts[first + x];
    if (!m_carriedCounts.empty())
        for (std::size_t x = 0; x < width; ++x)
            samples[x] += m_carriedCounts[first + x];
    for (const auto& colours : m_colours)
        for (std::size_t x = 0; x < width; ++x)
            samples[x] += colours[first + x].samples;
    for (const auto& carried : m_carriedColours)
        for (std::size_t x = 0; x < width && !carried.empty(); ++x)
            samples[x] += carried[first + x].samples;
}

void CellSums::sumsOfRow(int row, std::vector<Sum>& sums) const {
    const auto width = static_cast<std::size_t>(m_window.width);
    const std::size_t first = static_cast<std::size_t>(row) * width;
    sums.assign(width, {});
    const auto add = [&](const auto& cells) {
        for (std::size_t x = 0; x < width; ++x) {
            sums[x].samples += cells[first + x].samples;
            sums[x].red += cells[first + x].red;
            sums[x].green += cells[first + x].green;
            sums[x].blue += cells[first + x].blue;
        }
    };
    for (const auto& colours : m_colours)
        add(colours);
    for (const auto& carried : m_carriedColours)
        if (!carried.empty()) add(carried);
}

} // namespace attractor
