// SPDX-License-Identifier: MIT
#include "attractor/cells/splat.h"

#include "attractor/kernels/kernels.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

struct Reach {
    float left = 0, right = 0, top = 0, bottom = 0;
};

// Bounds of the samples: exact, because rounding is monotonic and the corners are rounded like the samples.
Reach affineReach(const Word& word, const SampleSet& samples) {
    const auto extreme = [&](float a, float b, float c, bool high) {
        const float x = (a >= 0) == high ? samples.highX : samples.lowX;
        const float y = (b >= 0) == high ? samples.highY : samples.lowY;
        return a * x + b * y + c;
    };
    return {extreme(word.xx, word.xy, word.x, false), extreme(word.xx, word.xy, word.x, true),
            extreme(word.yx, word.yy, word.y, false), extreme(word.yx, word.yy, word.y, true)};
}

// Bounds of the samples on a curved word, with each term at its maximum.
Reach curvedReach(const Word& word, const Curve& curve, const SampleSet& samples) {
    constexpr float rounding = 1e-5F;
    const float a = std::max(std::abs(samples.lowX), std::abs(samples.highX));
    const float b = std::max(std::abs(samples.lowY), std::abs(samples.highY));
    const auto half = [&](float p, float q, float r, float aa, float ab, float bb) {
        const float terms = std::abs(p) * a + std::abs(q) * b + std::abs(aa) * (a * a) +
                            std::abs(ab) * (a * b) + std::abs(bb) * (b * b);
        return terms + rounding * (terms + std::abs(r));
    };
    const float x = half(word.xx, word.xy, word.x, curve.xaa, curve.xab, curve.xbb);
    const float y = half(word.yx, word.yy, word.y, curve.yaa, curve.yab, curve.ybb);
    return {word.x - x, word.x + x, word.y - y, word.y + y};
}

Reach reach(const ShownWord& shown, const SampleSet& samples) {
    return shown.curve == nullptr ? affineReach(shown.word, samples)
                                  : curvedReach(shown.word, *shown.curve, samples);
}

bool inside(const Reach& r, const CellWindow& window) {
    return r.left >= 0 && r.right < static_cast<float>(window.width) &&
           r.top >= static_cast<float>(window.firstRow) && r.bottom < static_cast<float>(window.endRow);
}

bool outside(const Reach& r, const CellWindow& window) {
    return window.cells() == 0 || r.right < 0 || r.left >= static_cast<float>(window.width) ||
           r.bottom < static_cast<float>(window.firstRow) || r.top >= static_cast<float>(window.endRow);
}

// The cell of a coordinate, or the nearest one; NaN meets no cell at all.
int cellWithin(float value, int first, int end) {
    if (!(value > static_cast<float>(first))) return first;
    return value < static_cast<float>(end) ? std::min(static_cast<int>(value), end - 1) : end - 1;
}

kernels::Patch patch(const Reach& r) {
    const int column = static_cast<int>(r.left);
    const int row = static_cast<int>(r.top);
    return {column, row, static_cast<int>(r.right) - column + 1, static_cast<int>(r.bottom) - row + 1};
}

std::size_t cellIndex(int column, int row, const CellWindow& window) {
    return static_cast<std::size_t>(row - window.firstRow) * static_cast<std::size_t>(window.width) +
           static_cast<std::size_t>(column);
}

// More samples than the set holds go round it again.
template <class Work>
void forEachRun(const Word& word, const SampleSet& samples, std::uint64_t count, Work work) {
    while (count > 0) {
        const auto run = static_cast<std::size_t>(std::min<std::uint64_t>(count, SampleSet::size));
        work(kernels::Run{samples.x.data() + word.offset, samples.y.data() + word.offset, run});
        count -= run;
    }
}

} // namespace

CellRegion reachedCells(const ShownWord& shown, const SampleSet& samples, const CellWindow& window) {
    const Reach r = reach(shown, samples);
    if (outside(r, window)) return {};
    return {cellWithin(r.left, 0, window.width), cellWithin(r.right, 0, window.width) + 1,
            cellWithin(r.top, window.firstRow, window.endRow),
            cellWithin(r.bottom, window.firstRow, window.endRow) + 1};
}

bool meets(const ShownWord& shown, const SampleSet& samples, const CellWindow& window) {
    return !outside(reach(shown, samples), window);
}

void splat(const ShownWord& shown, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           std::uint32_t* counts) {
    const Reach r = reach(shown, samples);
    if (outside(r, window)) return;
    if (inside(r, window)) {
        const kernels::Patch p = patch(r);
        if (p.width == 1 && p.height == 1) {
            counts[cellIndex(p.column, p.row, window)] += static_cast<std::uint32_t>(count);
            return;
        }
        // Limit that keeps clearing and adding up the copies cheap compared with counting.
        const auto max = static_cast<int>(std::min<std::uint64_t>(count / 16, kernels::patchCells));
        if (shown.curve == nullptr && p.width <= max && p.height <= max && p.width * p.height <= max) {
            forEachRun(shown.word, samples, count, [&](const kernels::Run& run) {
                kernels::addToPatch(shown.word, run, p, window, counts);
            });
            return;
        }
        forEachRun(shown.word, samples, count,
                   [&](const kernels::Run& run) { kernels::addInside(shown, run, window, counts); });
        return;
    }
    forEachRun(shown.word, samples, count,
               [&](const kernels::Run& run) { kernels::addToCounts(shown, run, window, counts); });
}

bool splat(const ShownWord& shown, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           const ColourCell& colour, ColourCell* cells) {
    const Reach r = reach(shown, samples);
    if (outside(r, window)) return false;
    std::uint32_t seen = 0;
    if (inside(r, window)) {
        forEachRun(shown.word, samples, count, [&](const kernels::Run& run) {
            seen |= kernels::addToColoursInside(shown, run, window, colour, cells);
        });
        return seen >> 31 != 0;
    }
    forEachRun(shown.word, samples, count, [&](const kernels::Run& run) {
        // Cleared: samples outside the window must not influence the overflow check of its cells.
        std::fill_n(cells + window.cells(), overflowCells, ColourCell{});
        seen |= kernels::addToColours(shown, run, window, colour, cells);
    });
    return seen >> 31 != 0;
}

} // namespace attractor
