// SPDX-License-Identifier: MIT
#include "attractor/kernels/key_splat.h"

#include "attractor/kernels/kernels.h"

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

// Stores keys so that the last one stays: neither a comparison nor the previous value of a pixel is needed.
template <kernels::KeyReach reach>
HWY_ATTR static void putKeysThat(const KeyWord& word, const float* HWY_RESTRICT xs,
                                 const float* HWY_RESTRICT ys, std::size_t count, const KeyRows& rows) {
    const Float d;
    const Int di;
    const Unsigned du;
    const std::size_t n = hn::Lanes(d);
    const FloatVector zero = hn::Zero(d);
    const FloatVector width = hn::Set(d, static_cast<float>(rows.width));
    const FloatVector first = hn::Set(d, static_cast<float>(rows.firstRow));
    const FloatVector end = hn::Set(d, static_cast<float>(rows.endRow));
    const IntVector firstRow = hn::Set(di, rows.firstRow);
    const IntVector stride = hn::Set(di, rows.width);
    const auto last = hn::Set(du, static_cast<std::uint32_t>(rows.keys.size() - 1));
    std::uint32_t* HWY_RESTRICT keys = rows.keys.data();
    alignas(64) std::uint32_t cells[maxLanes];
    const auto storeCells = [&](FloatVector column, FloatVector row) HWY_ATTR {
        const IntVector rowNumber = hn::Sub(truncated(row), firstRow);
        const auto cell = hn::BitCast(du, hn::Add(hn::Mul(rowNumber, stride), truncated(column)));
        hn::Store(hn::Min(cell, last), du, cells); // in range for any number
    };
    for (std::size_t k = (count + n - 1) / n * n; k > 0;) {
        k -= n;
        const FloatVector x = hn::LoadU(d, xs + k);
        const FloatVector y = hn::LoadU(d, ys + k);
        const FloatVector column = affine(word.xx, word.xy, word.x, x, y);
        const FloatVector row = affine(word.yx, word.yy, word.y, x, y);
        const std::uint32_t key = word.firstKey + static_cast<std::uint32_t>(k);
        if constexpr (reach == kernels::KeyReach::Inside) {
            storeCells(column, row);
            for (std::size_t lane = n; lane-- > 0;)
                keys[cells[lane]] = key + static_cast<std::uint32_t>(lane);
        } else {
            const auto in = hn::And(hn::And(hn::Ge(column, zero), hn::Lt(column, width)),
                                    hn::And(hn::Ge(row, first), hn::Lt(row, end)));
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, in, bits);
            storeCells(hn::IfThenElseZero(in, column), hn::IfThenElse(in, row, first));
            for (unsigned left = bits[0] | static_cast<unsigned>(bits[1]) << 8; left != 0;) {
                const auto lane = static_cast<unsigned>(std::bit_width(left)) - 1;
                keys[cells[lane]] = key + lane;
                left ^= 1U << lane;
            }
        }
    }
}

HWY_ATTR void putKeys(const KeyWord& word, kernels::KeyReach reach, const float* xs, const float* ys,
                      std::size_t count, const KeyRows& rows) {
    if (reach == kernels::KeyReach::Inside)
        putKeysThat<kernels::KeyReach::Inside>(word, xs, ys, count, rows);
    else
        putKeysThat<kernels::KeyReach::Across>(word, xs, ys, count, rows);
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace attractor::kernels {

HWY_EXPORT(putKeys);

void putKeys(const KeyWord& word, KeyReach reach, const float* x, const float* y, std::size_t count,
             const KeyRows& rows) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(putKeys)(word, reach, x, y, count, rows);
}

} // namespace attractor::kernels
#endif
