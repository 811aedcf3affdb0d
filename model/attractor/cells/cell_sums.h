// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/cells.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <vector>

namespace attractor {

enum class CellKind { Count, Colour };

// Samples counted in the cells of a window: 32-bit counters of every thread, and 64-bit sums into which they
// are carried over before they can wrap. The sum does not depend on which thread counted what. A fractal
// leaves most of its window empty: counters are cleared tile by tile when they are first requested, and
// readers skip tiles that were never requested.
class CellSums {
public:
    // The largest number of colours whose samples can be counted in no more memory than their sum takes.
    static constexpr std::size_t maxLayers = sizeof(ColourCell) / sizeof(std::uint32_t);

    // Zero everywhere; memory of an earlier use is kept where it fits. CellKind::Colour: where there are but
    // few colours, at most maxLayers, samples are counted in a layer for each.
    void reset(CellKind kind, const CellWindow& window, std::size_t threads,
               std::span<const ColourCell> layers = {});

    CellKind kind() const { return m_kind; }
    const CellWindow& window() const { return m_window; }

    // The counters of a thread, of all of the window and of the overflow. With a region they may be used
    // there only. Thread-safe for different threads.
    std::uint32_t* counts(std::size_t thread) { return touch(m_counts[thread], all()); }
    std::uint32_t* counts(std::size_t thread, const CellRegion& region) {
        return touch(m_counts[thread], region);
    }
    bool layered() const { return !m_layerColours.empty(); }
    std::uint32_t* layer(std::size_t thread, std::size_t layer) {
        return touch(m_layers[thread * m_layerColours.size() + layer], all());
    }
    std::uint32_t* layer(std::size_t thread, std::size_t layer, const CellRegion& region) {
        return touch(m_layers[thread * m_layerColours.size() + layer], region);
    }
    // Colour cells; available only without layers.
    ColourCell* colours(std::size_t thread) { return touch(m_colours[thread], all()); }
    ColourCell* colours(std::size_t thread, const CellRegion& region) {
        return touch(m_colours[thread], region);
    }

    void carryOverColours(std::size_t thread); // may run for different threads at once
    void carryOverCounts();                    // includes the counters of all threads and layers

    // Returns true if there are 64-bit sums besides the 32-bit counters.
    bool carried() const { return !m_carriedCounts.empty(); }
    // The counters that have to be added up in the columns from one to another, none where nothing fell.
    struct Piece {
        std::size_t firstColumn = 0;
        std::size_t endColumn = 0;
        std::vector<const std::uint32_t*> counts; // pointers to the first column
    };
    // A row of the window in pieces; the rows up to `endRow` have the same ones, each a width farther on.
    struct Pieces {
        std::vector<Piece> pieces;
        int endRow = 0;
    };
    Pieces pieces(int row) const; // CellKind::Count

    struct Sum {
        std::uint64_t samples = 0;
        std::uint64_t red = 0; // 12 bits for each channel and sample
        std::uint64_t green = 0;
        std::uint64_t blue = 0;

        Sum& operator+=(const auto& other) { // a Sum or a ColourCell
            samples += other.samples;
            red += other.red;
            green += other.green;
            blue += other.blue;
            return *this;
        }
        // Adds `count` samples of one colour.
        void add(std::uint32_t count, const ColourCell& colour) {
            samples += count;
            red += std::uint64_t{count} * colour.red;
            green += std::uint64_t{count} * colour.green;
            blue += std::uint64_t{count} * colour.blue;
        }
    };
    // Row `row` of the window: one value per column, sums over all threads. False where all are zero.
    bool samplesOfRow(int row, std::vector<std::uint64_t>& samples) const;
    // Sums over all threads.
    bool samplesOfRows(int firstRow, int endRow, std::vector<std::uint64_t>& samples) const;
    bool sumsOfRow(int row, std::vector<Sum>& sums) const; // CellKind::Colour

    // Adds counts made elsewhere to row `row` of the window, from a column on.
    void addSamples(int row, int firstColumn, std::span<const std::uint64_t> samples); // CellKind::Count
    void addSums(int row, int firstColumn, std::span<const Sum> sums);                 // CellKind::Colour

private:
    static constexpr int tileColumns = 256;
    static constexpr int tileRows = 16;

    struct Release {
        void operator()(void* memory) const { ::operator delete(memory); }
    };
    // The cells of one thread. Tiles that have not been touched are uninitialized and never written, so that
    // they take no memory.
    template <class Cell> struct Counters {
        std::unique_ptr<Cell[], Release> cells;
        std::size_t size = 0;
        std::vector<std::uint8_t> touched; // one flag for each tile
        bool whole = false;                // true: all tiles
    };

    CellRegion all() const { return {0, m_window.width, m_window.firstRow, m_window.endRow}; }
    std::size_t cellAt(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_window.width) +
               static_cast<std::size_t>(column);
    }
    int tilesAcross() const { return (m_window.width + tileColumns - 1) / tileColumns; }
    std::size_t tileOf(int row, int tileColumn) const {
        return static_cast<std::size_t>(row / tileRows) * static_cast<std::size_t>(tilesAcross()) +
               static_cast<std::size_t>(tileColumn);
    }
    template <class Cell> void reset(std::vector<Counters<Cell>>& all, std::size_t threads) const;
    // Calls work(first column, cells from there on, their number, colour) for the touched parts of a row.
    template <class Work> bool forLayers(int row, Work work) const;
    template <class Cell> void forget(Counters<Cell>& counters) const;
    template <class Cell> Cell* touch(Counters<Cell>& counters, const CellRegion& region) const;
    template <class Cell> void clear(Cell* cells, int tileRow, int tileColumn) const;
    // Calls work(first column, end column, cells from the first column) for the touched parts of a row.
    template <class Cell, class Work>
    bool forTouched(const Counters<Cell>& counters, int row, Work work) const;

    CellKind m_kind = CellKind::Count;
    CellWindow m_window;
    std::vector<Counters<std::uint32_t>> m_counts;
    std::vector<std::uint64_t> m_carriedCounts;
    std::vector<ColourCell> m_layerColours;
    std::vector<Counters<std::uint32_t>> m_layers; // layers of each thread in turn
    std::vector<Counters<ColourCell>> m_colours;
    std::vector<std::vector<Sum>> m_carriedColours;
};

} // namespace attractor
