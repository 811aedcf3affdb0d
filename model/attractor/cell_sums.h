// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/splat.h"

#include <cstdint>
#include <vector>

namespace attractor {

enum class CellKind { Count, Colour };

// What has fallen into the cells of a window: 32-bit counters of every thread, and 64-bit sums into which
// they are carried over before they can wrap. The sum does not depend on who counted what.
class CellSums {
public:
    // Zero everywhere; memory of an earlier use is kept where it fits.
    void reset(CellKind kind, const CellWindow& window, std::size_t threads);

    CellKind kind() const { return m_kind; }
    const CellWindow& window() const { return m_window; }

    std::uint32_t* counts(std::size_t thread) { return m_counts[thread].data(); }
    ColourCell* colours(std::size_t thread) { return m_colours[thread].data(); }

    void carryOverColours(std::size_t thread); // thread-safe for different threads
    void carryOverCounts();                    // all threads' counters

    // Whether the 32-bit counters are all there is, and the pointers to them.
    bool carried() const { return !m_carriedCounts.empty(); }
    std::vector<const std::uint32_t*> counters() const;

    struct Sum {
        std::uint64_t samples = 0;
        std::uint64_t red = 0; // 12 bits a channel and sample
        std::uint64_t green = 0;
        std::uint64_t blue = 0;
    };
    // Row `row` of the window: one value per column, sums over all threads.
    void samplesOfRow(int row, std::vector<std::uint64_t>& samples) const;
    void sumsOfRow(int row, std::vector<Sum>& sums) const; // CellKind::Colour

private:
    CellKind m_kind = CellKind::Count;
    CellWindow m_window;
    std::vector<std::vector<std::uint32_t>> m_counts;
    std::vector<std::uint64_t> m_carriedCounts;
    std::vector<std::vector<ColourCell>> m_colours;
    std::vector<std::vector<Sum>> m_carriedColours;
};

} // namespace attractor
