// SPDX-License-Identifier: MIT
#include "attractor/splat.h"

#include <algorithm>
#include <array>

namespace attractor {

namespace {

constexpr std::size_t chunk = 128;

using Cells = std::array<std::uint32_t, chunk>;

void cellsOf(const Word& word, const float* x, const float* y, std::size_t count, const CellWindow& window,
             Cells& cells) {
    const auto width = static_cast<float>(window.width);
    const auto first = static_cast<float>(window.firstRow);
    const auto end = static_cast<float>(window.endRow);
    const auto trash = static_cast<std::uint32_t>(window.cells());
    for (std::size_t k = 0; k < count; ++k) {
        const float column = word.xx * x[k] + word.xy * y[k] + word.x;
        const float row = word.yx * x[k] + word.yy * y[k] + word.y;
        const bool inside = column >= 0 && column < width && row >= first && row < end;
        cells[k] = inside ? static_cast<std::uint32_t>(static_cast<int>(row) - window.firstRow) *
                                    static_cast<std::uint32_t>(window.width) +
                                static_cast<std::uint32_t>(static_cast<int>(column))
                          : trash + static_cast<std::uint32_t>(k % trashCells);
    }
}

template <class Add>
void forEachCell(const Word& word, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
                 Add add) {
    Cells cells;
    while (count > 0) {
        const auto run = static_cast<std::size_t>(std::min<std::uint64_t>(count, SampleSet::size));
        for (std::size_t done = 0; done < run; done += chunk) {
            const std::size_t n = std::min(chunk, run - done);
            cellsOf(word, samples.x.data() + word.offset + done, samples.y.data() + word.offset + done, n,
                    window, cells);
            for (std::size_t k = 0; k < n; ++k)
                add(cells[k]);
        }
        count -= run;
    }
}

} // namespace

void splat(const Word& word, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           std::uint32_t* counts) {
    forEachCell(word, samples, count, window, [counts](std::uint32_t cell) { ++counts[cell]; });
}

bool splat(const Word& word, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           const ColourCell& colour, ColourCell* cells) {
    std::uint32_t seen = 0;
    forEachCell(word, samples, count, window, [&](std::uint32_t at) {
        ColourCell& cell = cells[at];
        cell.samples += colour.samples;
        cell.red += colour.red;
        cell.green += colour.green;
        cell.blue += colour.blue;
        seen |= cell.samples | cell.red | cell.green | cell.blue;
    });
    return seen >> 31 != 0;
}

} // namespace attractor
