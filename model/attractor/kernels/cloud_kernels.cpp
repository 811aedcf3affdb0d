// SPDX-License-Identifier: MIT
#include "attractor/kernels/cloud_kernels.h"

#include "attractor/kernels/kernels.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "attractor/kernels/cloud_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "attractor/kernels/vectors-inl.h" // for each target: behind foreach_target.h

HWY_BEFORE_NAMESPACE();
namespace attractor::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using kernels::chunk;
using kernels::CloudWord;
using kernels::SpaceRun;

struct Row {
    FloatVector a, b, c, constant;

    HWY_ATTR Row(const std::array<float, 3>& linear, float shift)
        : a(hn::Set(Float(), linear[0])),
          b(hn::Set(Float(), linear[1])),
          c(hn::Set(Float(), linear[2])),
          constant(hn::Set(Float(), shift)) {}
    HWY_ATTR HWY_INLINE FloatVector operator()(FloatVector x, FloatVector y, FloatVector z) const {
        // Never fused.
        return hn::Add(hn::Add(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), hn::Mul(c, z)), constant);
    }
};

// The cells of at most 128 points; overflow cells for those outside the window.
template <bool inside>
HWY_ATTR static HWY_INLINE void cellsOf(const CloudWord& word, const CellWindow& window,
                                        const SpaceRun& points, std::uint32_t* HWY_RESTRICT cells) {
    const Float d;
    const Int di;
    const Row columns(word.column, word.x);
    const Row rows(word.row, word.y);
    const FloatVector zero = hn::Zero(d);
    const FloatVector width = hn::Set(d, static_cast<float>(window.width));
    const FloatVector first = hn::Set(d, static_cast<float>(window.firstRow));
    const FloatVector end = hn::Set(d, static_cast<float>(window.endRow));
    const IntVector stride = hn::Set(di, window.width);
    const IntVector origin = hn::Set(di, window.firstRow);
    const IntVector overflow = hn::Iota(di, static_cast<std::int32_t>(window.cells()));
    for (std::size_t k = 0; k < points.count; k += hn::Lanes(d)) {
        const FloatVector x = hn::LoadU(d, points.x + k);
        const FloatVector y = hn::LoadU(d, points.y + k);
        const FloatVector z = hn::LoadU(d, points.z + k);
        FloatVector column = columns(x, y, z);
        FloatVector row = rows(x, y, z);
        [[maybe_unused]] const auto in = hn::And(hn::And(hn::Ge(column, zero), hn::Lt(column, width)),
                                                 hn::And(hn::Ge(row, first), hn::Lt(row, end)));
        if constexpr (!inside) {
            column = hn::IfThenElseZero(in, column);
            row = hn::IfThenElse(in, row, first);
        }
        IntVector cell = hn::Add(hn::Mul(hn::Sub(truncated(row), origin), stride), truncated(column));
        if constexpr (!inside) {
            const IntVector outside =
                hn::Add(overflow, hn::Set(di, static_cast<std::int32_t>(k % overflowCells)));
            cell = hn::IfThenElse(hn::RebindMask(di, in), cell, outside);
        }
        hn::Store(cell, di, reinterpret_cast<std::int32_t*>(cells) + k);
    }
}

template <bool inside>
HWY_ATTR static HWY_INLINE void addTo(const CloudWord& word, const SpaceRun& run, const CellWindow& window,
                                      std::uint32_t* HWY_RESTRICT counts) {
    alignas(64) std::uint32_t cells[chunk];
    std::size_t done = 0;
    for (; done + chunk <= run.count; done += chunk) {
        cellsOf<inside>(word, window, {run.x + done, run.y + done, run.z + done, chunk}, cells);
#pragma GCC unroll 8
        for (std::size_t k = 0; k < chunk; ++k)
            ++counts[cells[k]];
    }
    const std::size_t rest = run.count - done;
    cellsOf<inside>(word, window, {run.x + done, run.y + done, run.z + done, rest}, cells);
    for (std::size_t k = 0; k < rest; ++k)
        ++counts[cells[k]];
}

HWY_ATTR void addCloud(const CloudWord& word, const SpaceRun& run, const CellWindow& window,
                       std::uint32_t* HWY_RESTRICT counts) {
    addTo<false>(word, run, window, counts);
}

HWY_ATTR void addCloudInside(const CloudWord& word, const SpaceRun& run, const CellWindow& window,
                             std::uint32_t* HWY_RESTRICT counts) {
    addTo<true>(word, run, window, counts);
}

HWY_ATTR std::uint32_t addCloudColours(const CloudWord& word, const SpaceRun& run, const CellWindow& window,
                                       const ColourCell& colour, ColourCell* HWY_RESTRICT sums) {
    alignas(64) std::uint32_t cells[chunk];
    std::uint32_t seen = 0;
    for (std::size_t done = 0; done < run.count; done += chunk) {
        const std::size_t count = run.count - done < chunk ? run.count - done : chunk;
        cellsOf<false>(word, window, {run.x + done, run.y + done, run.z + done, count}, cells);
        for (std::size_t k = 0; k < count; ++k) {
            ColourCell& cell = sums[cells[k]];
            cell.samples += colour.samples;
            cell.red += colour.red;
            cell.green += colour.green;
            cell.blue += colour.blue;
            seen |= cell.samples | cell.red | cell.green | cell.blue;
        }
    }
    return seen;
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace attractor {

HWY_EXPORT(addCloud);
HWY_EXPORT(addCloudInside);
HWY_EXPORT(addCloudColours);

namespace kernels {

void addToCounts(const CloudWord& word, const SpaceRun& run, const CellWindow& window,
                 std::uint32_t* counts) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(addCloud)(word, run, window, counts);
}

void addInside(const CloudWord& word, const SpaceRun& run, const CellWindow& window, std::uint32_t* counts) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(addCloudInside)(word, run, window, counts);
}

std::uint32_t addToColours(const CloudWord& word, const SpaceRun& run, const CellWindow& window,
                           const ColourCell& colour, ColourCell* cells) {
    heedEnvironment();
    return HWY_DYNAMIC_DISPATCH(addCloudColours)(word, run, window, colour, cells);
}

} // namespace kernels
} // namespace attractor
#endif
