// SPDX-License-Identifier: MIT
#include "attractor/cells/cell_sums.h"

#include <algorithm>

namespace attractor {

template <class Cell> void CellSums::forget(Counters<Cell>& counters) const {
    const int tilesDown = (m_window.endRow - m_window.firstRow + tileRows - 1) / tileRows;
    counters.touched.assign(static_cast<std::size_t>(tilesAcross()) * static_cast<std::size_t>(tilesDown), 0);
    counters.whole = false;
}

template <class Cell> void CellSums::reset(std::vector<Counters<Cell>>& all, std::size_t threads) const {
    all.resize(threads);
    const std::size_t size = m_window.cells() + overflowCells;
    for (Counters<Cell>& counters : all) {
        if (counters.size < size || counters.size > 4 * size) {
            counters.cells.reset(); // releases memory before allocating more
            counters.cells.reset(static_cast<Cell*>(::operator new(size * sizeof(Cell))));
            counters.size = size;
        }
        std::fill_n(counters.cells.get() + m_window.cells(), overflowCells, Cell{});
        forget(counters);
    }
}

void CellSums::reset(CellKind kind, const CellWindow& window, std::size_t threads,
                     std::span<const ColourCell> layers) {
    m_kind = kind;
    m_window = window;
    m_layerColours.assign(layers.begin(), layers.end());
    reset(m_counts, kind == CellKind::Count ? threads : 0);
    reset(m_layers, threads * layers.size());
    reset(m_colours, kind == CellKind::Colour && layers.empty() ? threads : 0);
    m_carriedCounts = {};
    m_carriedColours.clear();
    m_carriedColours.resize(kind == CellKind::Colour ? threads : 0);
}

template <class Cell> void CellSums::clear(Cell* cells, int tileRow, int tileColumn) const {
    const int height = m_window.endRow - m_window.firstRow;
    const int first = tileColumn * tileColumns;
    const int columns = std::min(tileColumns, m_window.width - first);
    for (int row = tileRow * tileRows; row < std::min(height, (tileRow + 1) * tileRows); ++row)
        std::fill_n(cells + static_cast<std::size_t>(row) * static_cast<std::size_t>(m_window.width) + first,
                    columns, Cell{});
}

template <class Cell> Cell* CellSums::touch(Counters<Cell>& counters, const CellRegion& region) const {
    Cell* const cells = counters.cells.get();
    if (counters.whole || region.endColumn <= region.firstColumn || region.endRow <= region.firstRow)
        return cells;
    const int lastRow = (region.endRow - 1 - m_window.firstRow) / tileRows;
    const int lastColumn = (region.endColumn - 1) / tileColumns;
    for (int row = (region.firstRow - m_window.firstRow) / tileRows; row <= lastRow; ++row)
        for (int column = region.firstColumn / tileColumns; column <= lastColumn; ++column) {
            std::uint8_t& touched = counters.touched[tileOf(row * tileRows, column)];
            if (touched != 0) continue;
            clear(cells, row, column);
            touched = 1;
        }
    // Written only if changed: the next thread's counters may share the cache line.
    if (region == all()) counters.whole = true;
    return cells;
}

template std::uint32_t* CellSums::touch(Counters<std::uint32_t>&, const CellRegion&) const;
template ColourCell* CellSums::touch(Counters<ColourCell>&, const CellRegion&) const;

template <class Cell, class Work>
bool CellSums::forTouched(const Counters<Cell>& counters, int row, Work work) const {
    bool any = false;
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(m_window.width);
    for (int tile = 0; tile < tilesAcross(); ++tile) {
        if (counters.touched[tileOf(row, tile)] == 0) continue;
        const auto first = std::size_t(tile) * tileColumns;
        const auto end = static_cast<std::size_t>(std::min(m_window.width, (tile + 1) * tileColumns));
        work(first, end, counters.cells.get() + start + first);
        any = true;
    }
    return any;
}

void CellSums::carryOverColours(std::size_t thread) {
    std::vector<Sum>& carried = m_carriedColours[thread];
    carried.resize(m_window.cells());
    const ColourCell* const cells = colours(thread);
    for (std::size_t i = 0; i < carried.size(); ++i) {
        carried[i] += cells[i];
    }
    forget(m_colours[thread]);
}

void CellSums::carryOverCounts() {
    if (!m_counts.empty()) m_carriedCounts.resize(m_window.cells());
    for (std::size_t thread = 0; thread < m_counts.size(); ++thread) {
        const std::uint32_t* const cells = counts(thread);
        for (std::size_t i = 0; i < m_carriedCounts.size(); ++i)
            m_carriedCounts[i] += cells[i];
        forget(m_counts[thread]);
    }
    for (std::size_t k = 0; k < m_layers.size(); ++k) {
        std::vector<Sum>& carried = m_carriedColours.front();
        carried.resize(m_window.cells());
        const ColourCell& colour = m_layerColours[k % m_layerColours.size()];
        const std::uint32_t* const cells = touch(m_layers[k], all());
        for (std::size_t i = 0; i < carried.size(); ++i)
            carried[i].add(cells[i], colour);
        forget(m_layers[k]);
    }
}

template <class Work> bool CellSums::forLayers(int row, Work work) const {
    bool any = false;
    for (std::size_t k = 0; k < m_layers.size(); ++k) {
        const ColourCell& colour = m_layerColours[k % m_layerColours.size()];
        any |=
            forTouched(m_layers[k], row, [&](std::size_t first, std::size_t end, const std::uint32_t* cells) {
                work(first, cells, end - first, colour);
            });
    }
    return any;
}

CellSums::Pieces CellSums::pieces(int row) const {
    Pieces result;
    result.endRow = std::min(m_window.endRow - m_window.firstRow, (row / tileRows + 1) * tileRows);
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(m_window.width);
    for (int tile = 0; tile < tilesAcross(); ++tile) {
        const auto first = std::size_t(tile) * tileColumns;
        Piece piece{first, static_cast<std::size_t>(std::min(m_window.width, (tile + 1) * tileColumns)), {}};
        bool same = tile > 0; // same threads as in the previous tile
        for (const Counters<std::uint32_t>& counters : m_counts) {
            const bool touched = counters.touched[tileOf(row, tile)] != 0;
            if (touched) piece.counts.push_back(counters.cells.get() + start + first);
            same = same && touched == (counters.touched[tileOf(row, tile - 1)] != 0);
        }
        if (same)
            result.pieces.back().endColumn = piece.endColumn;
        else
            result.pieces.push_back(std::move(piece));
    }
    return result;
}

bool CellSums::samplesOfRow(int row, std::vector<std::uint64_t>& samples) const {
    return samplesOfRows(row, row + 1, samples);
}

bool CellSums::samplesOfRows(int firstRow, int endRow, std::vector<std::uint64_t>& samples) const {
    const auto width = static_cast<std::size_t>(m_window.width);
    samples.assign(width, 0);
    bool any = carried();
    const auto add = [&](std::size_t column, std::size_t count, auto samplesAt) {
        std::uint64_t* const out = samples.data() + column;
        for (std::size_t i = 0; i < count; ++i)
            out[i] += samplesAt(i);
    };
    for (int row = firstRow; row < endRow; ++row) {
        const std::size_t start = static_cast<std::size_t>(row) * width;
        for (const auto& counters : m_counts)
            any |= forTouched(counters, row,
                              [&](std::size_t first, std::size_t end, const std::uint32_t* cells) {
                                  add(first, end - first, [cells](std::size_t i) { return cells[i]; });
                              });
        if (carried()) add(0, width, [&](std::size_t i) { return m_carriedCounts[start + i]; });
        any |= forLayers(row,
                         [&](std::size_t first, const std::uint32_t* cells, std::size_t count, const auto&) {
                             add(first, count, [cells](std::size_t i) { return cells[i]; });
                         });
        for (const auto& counters : m_colours)
            any |=
                forTouched(counters, row, [&](std::size_t first, std::size_t end, const ColourCell* cells) {
                    add(first, end - first, [cells](std::size_t i) { return cells[i].samples; });
                });
        for (const auto& sums : m_carriedColours) {
            if (sums.empty()) continue;
            any = true;
            add(0, width, [&](std::size_t i) { return sums[start + i].samples; });
        }
    }
    return any;
}

bool CellSums::sumsOfRow(int row, std::vector<Sum>& sums) const {
    const auto width = static_cast<std::size_t>(m_window.width);
    sums.assign(width, {});
    bool any = false;
    const auto add = [&](std::size_t first, std::size_t end, const auto* cells) {
        for (std::size_t x = first; x < end; ++x) {
            sums[x] += cells[x - first];
        }
    };
    any |= forLayers(
        row, [&](std::size_t first, const std::uint32_t* cells, std::size_t count, const ColourCell& colour) {
            for (std::size_t i = 0; i < count; ++i)
                sums[first + i].add(cells[i], colour);
        });
    for (const auto& counters : m_colours)
        any |= forTouched(counters, row, add);
    for (const auto& carried : m_carriedColours) {
        if (carried.empty()) continue;
        add(0, width, carried.data() + static_cast<std::size_t>(row) * width);
        any = true;
    }
    return any;
}

void CellSums::addSamples(int row, int firstColumn, std::span<const std::uint64_t> samples) {
    m_carriedCounts.resize(m_window.cells());
    std::uint64_t* const cells = m_carriedCounts.data() + cellAt(row, firstColumn);
    for (std::size_t x = 0; x < samples.size(); ++x)
        cells[x] += samples[x];
}

void CellSums::addSums(int row, int firstColumn, std::span<const Sum> sums) {
    std::vector<Sum>& carried = m_carriedColours.front();
    carried.resize(m_window.cells());
    Sum* const cells = carried.data() + cellAt(row, firstColumn);
    for (std::size_t x = 0; x < sums.size(); ++x)
        cells[x] += sums[x];
}

} // namespace attractor
