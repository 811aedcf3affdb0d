// SPDX-License-Identifier: MIT
#include "attractor/curved_splat.h"

#include <algorithm>

#define HWY_DISABLED_TARGETS HWY_SSSE3 // as in kernels.cpp
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "attractor/curved_splat.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace attractor::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The cells of 128 points, trash cells for those outside the window. Nothing is fused, so that every
// instruction set gives the same.
HWY_ATTR void curvedCells(const Word& word, const Curve& curve, const float* x, const float* y,
                          const CellWindow& window, std::uint32_t* HWY_RESTRICT cells) {
    const hn::CappedTag<float, 16> d;
    const hn::RebindToSigned<decltype(d)> di;
    const auto zero = hn::Zero(d);
    const auto width = hn::Set(d, static_cast<float>(window.width));
    const auto first = hn::Set(d, static_cast<float>(window.firstRow));
    const auto end = hn::Set(d, static_cast<float>(window.endRow));
    const auto firstRow = hn::Set(di, window.firstRow);
    const auto stride = hn::Set(di, window.width);
    const auto lane = hn::Iota(di, 0);
    const auto trash = static_cast<std::int32_t>(window.cells());
    for (std::size_t k = 0; k < 128; k += hn::Lanes(d)) {
        const auto a = hn::LoadU(d, x + k);
        const auto b = hn::LoadU(d, y + k);
        // (p + aa·a + ab·b)·a + (q + bb·b)·b + r
        const auto second = [&](float p, float aa, float ab, float q, float bb, float r) HWY_ATTR {
            const auto alongA =
                hn::Add(hn::Add(hn::Mul(hn::Set(d, aa), a), hn::Mul(hn::Set(d, ab), b)), hn::Set(d, p));
            const auto alongB = hn::Add(hn::Mul(hn::Set(d, bb), b), hn::Set(d, q));
            return hn::Add(hn::Add(hn::Mul(alongA, a), hn::Mul(alongB, b)), hn::Set(d, r));
        };
        const auto column = second(word.xx, curve.xaa, curve.xab, word.xy, curve.xbb, word.x);
        const auto row = second(word.yx, curve.yaa, curve.yab, word.yy, curve.ybb, word.y);
        const auto inside = hn::And(hn::And(hn::Ge(column, zero), hn::Lt(column, width)),
                                    hn::And(hn::Ge(row, first), hn::Lt(row, end)));
        const auto c = hn::ConvertTo(di, hn::IfThenElseZero(inside, column));
        const auto r = hn::ConvertTo(di, hn::IfThenElse(inside, row, first));
        const auto cell = hn::Add(hn::Mul(hn::Sub(r, firstRow), stride), c);
        const auto outside = hn::Add(hn::Set(di, trash + static_cast<std::int32_t>(k % trashCells)), lane);
        hn::StoreU(hn::IfThenElse(hn::RebindMask(di, inside), cell, outside), di,
                   reinterpret_cast<std::int32_t*>(cells) + k);
    }
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace attractor {

HWY_EXPORT(curvedCells);

namespace {

constexpr std::size_t chunk = 128;

// Calls add(cell) for every sample. More samples than the set holds go round it again.
template <class Add>
void forEachCell(const Word& word, const Curve& curve, const SampleSet& samples, std::uint64_t count,
                 const CellWindow& window, Add add) {
    alignas(64) std::uint32_t cells[chunk];
    while (count > 0) {
        const auto run = static_cast<std::size_t>(std::min<std::uint64_t>(count, SampleSet::size));
        for (std::size_t done = 0; done < run; done += chunk) {
            const std::size_t at = word.offset + done;
            HWY_DYNAMIC_DISPATCH(curvedCells)
            (word, curve, samples.x.data() + at, samples.y.data() + at, window, cells);
            const std::size_t number = std::min(chunk, run - done);
            for (std::size_t k = 0; k < number; ++k)
                add(cells[k]);
        }
        count -= run;
    }
}

} // namespace

void splatCurved(const Word& word, const Curve& curve, const SampleSet& samples, std::uint64_t count,
                 const CellWindow& window, std::uint32_t* counts) {
    forEachCell(word, curve, samples, count, window, [counts](std::uint32_t cell) { ++counts[cell]; });
}

bool splatCurved(const Word& word, const Curve& curve, const SampleSet& samples, std::uint64_t count,
                 const CellWindow& window, const ColourCell& colour, ColourCell* cells) {
    std::uint32_t seen = 0;
    forEachCell(word, curve, samples, count, window, [&](std::uint32_t cell) {
        ColourCell& sum = cells[cell];
        sum.samples += colour.samples;
        sum.red += colour.red;
        sum.green += colour.green;
        sum.blue += colour.blue;
        seen |= sum.samples | sum.red | sum.green | sum.blue;
    });
    return seen >> 31 != 0;
}

} // namespace attractor
#endif
