// SPDX-License-Identifier: MIT
#include "attractor/kernels/key_splat.h"

#include "attractor/kernels/kernels.h"

#include <algorithm>
#include <bit>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "attractor/kernels/key_splat.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "attractor/kernels/vectors-inl.h" // for each target: behind foreach_target.h

HWY_BEFORE_NAMESPACE();
namespace attractor::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using kernels::KeyRows;
using kernels::KeyWord;

using Unsigned = hn::RebindToUnsigned<Float>;
constexpr std::size_t maxLanes = 16;
static_assert(hn::MaxLanes(Float()) <= maxLanes);

HWY_ATTR static HWY_INLINE FloatVector affine(float a, float b, float c, FloatVector x, FloatVector y) {
    const Float d;
    return hn::Add(hn::Add(hn::Mul(hn::Set(d, a), x), hn::Mul(hn::Set(d, b), y)),
                   hn::Set(d, c)); // never fused
}

// Gather, compare, store the few that are smaller.
HWY_ATTR void addKeys(const KeyWord& word, const float* xs, const float* ys, std::size_t count,
                      KeyRows& rows) {
    const Float d;
    const Int di;
    const Unsigned du;
    const FloatVector zero = hn::Zero(d);
    const FloatVector width = hn::Set(d, static_cast<float>(rows.width));
    const FloatVector first = hn::Set(d, static_cast<float>(rows.firstRow));
    const FloatVector end = hn::Set(d, static_cast<float>(rows.endRow));
    const IntVector firstRow = hn::Set(di, rows.firstRow);
    const IntVector stride = hn::Set(di, rows.width);
    const IntVector outside = hn::Set(di, static_cast<std::int32_t>(rows.keys.size() - 1));
    std::uint32_t* HWY_RESTRICT keys = rows.keys.data();
    const auto numbers = hn::Iota(du, word.firstKey);
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const FloatVector x = hn::LoadU(d, xs + k);
        const FloatVector y = hn::LoadU(d, ys + k);
        const FloatVector column = affine(word.xx, word.xy, word.x, x, y);
        const FloatVector row = affine(word.yx, word.yy, word.y, x, y);
        const auto in = hn::And(hn::And(hn::Ge(column, zero), hn::Lt(column, width)),
                                hn::And(hn::Ge(row, first), hn::Lt(row, end)));
        const IntVector rowNumber = hn::Sub(truncated(hn::IfThenElse(in, row, first)), firstRow);
        const IntVector cell = hn::IfThenElse(
            hn::RebindMask(di, in),
            hn::Add(hn::Mul(rowNumber, stride), truncated(hn::IfThenElseZero(in, column))), outside);
        const auto key = hn::Add(numbers, hn::Set(du, static_cast<std::uint32_t>(k)));
        const auto wins = hn::Lt(key, hn::GatherIndex(du, keys, cell));
        if (hn::AllFalse(du, wins)) continue;
        alignas(64) std::uint32_t newKeys[maxLanes];
        alignas(64) std::int32_t cells[maxLanes];
        std::uint8_t bits[8] = {};
        hn::Store(key, du, newKeys);
        hn::Store(cell, di, cells);
        hn::StoreMaskBits(du, wins, bits);
        for (unsigned left = bits[0] | static_cast<unsigned>(bits[1]) << 8; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            std::uint32_t& old = keys[cells[lane]];
            old = std::min(old, newKeys[lane]); // several may fall into one cell
        }
    }
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace attractor::kernels {

HWY_EXPORT(addKeys);

void KeyRows::reset(int columns, int first, int end) {
    width = columns;
    firstRow = first;
    endRow = end;
    keys.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(end - first) + 1, noKey);
    keys.back() = 0;
}

void addKeys(const KeyWord& word, const float* x, const float* y, std::size_t count, KeyRows& rows) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(addKeys)(word, x, y, count, rows);
}

} // namespace attractor::kernels
#endif
