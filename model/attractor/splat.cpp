// SPDX-License-Identifier: MIT
#include "attractor/splat.h"

#include "attractor/kernels.h"

#include <algorithm>

namespace attractor {

namespace {

// Where the samples fall: exact, because rounding is monotonic and the corners are rounded like the samples.
struct Reach {
    float left = 0, right = 0, top = 0, bottom = 0;
};

Reach reach(const Word& word, const SampleSet& samples) {
    const auto extreme = [&](float a, float b, float c, bool high) {
        const float x = (a >= 0) == high ? samples.highX : samples.lowX;
        const float y = (b >= 0) == high ? samples.highY : samples.lowY;
        return a * x + b * y + c;
    };
    return {extreme(word.xx, word.xy, word.x, false), extreme(word.xx, word.xy, word.x, true),
            extreme(word.yx, word.yy, word.y, false), extreme(word.yx, word.yy, word.y, true)};
}

bool inside(const Reach& r, const CellWindow& window) {
    return r.left >= 0 && r.right < static_cast<float>(window.width) &&
           r.top >= static_cast<float>(window.firstRow) && r.bottom < static_cast<float>(window.endRow);
}

bool outside(const Reach& r, const CellWindow& window) {
    return r.right < 0 || r.left >= static_cast<float>(window.width) ||
           r.bottom < static_cast<float>(window.firstRow) || r.top >= static_cast<float>(window.endRow);
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

bool meets(const Word& word, const SampleSet& samples, const CellWindow& window) {
    return !outside(reach(word, samples), window);
}

void splat(const Word& word, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           std::uint32_t* counts) {
    const Reach r = reach(word, samples);
    if (outside(r, window)) return;
    if (inside(r, window)) {
        const kernels::Patch p = patch(r);
        if (p.width == 1 && p.height == 1) {
            counts[cellIndex(p.column, p.row, window)] += static_cast<std::uint32_t>(count);
            return;
        }
        // Clearing and adding up the copies must stay small beside the counting itself.
        const auto most = static_cast<int>(std::min<std::uint64_t>(count / 16, kernels::patchCells));
        if (p.width <= most && p.height <= most && p.width * p.height <= most) {
            forEachRun(word, samples, count,
                       [&](const kernels::Run& run) { kernels::addToPatch(word, run, p, window, counts); });
            return;
        }
        forEachRun(word, samples, count,
                   [&](const kernels::Run& run) { kernels::addInside(word, run, window, counts); });
        return;
    }
    forEachRun(word, samples, count,
               [&](const kernels::Run& run) { kernels::addToCounts(word, run, window, counts); });
}

bool splat(const Word& word, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           const ColourCell& colour, ColourCell* cells) {
    if (outside(reach(word, samples), window)) return false;
    std::uint32_t seen = 0;
    forEachRun(word, samples, count, [&](const kernels::Run& run) {
        seen |= kernels::addToColours(word, run, window, colour, cells);
    });
    return seen >> 31 != 0;
}

} // namespace attractor
