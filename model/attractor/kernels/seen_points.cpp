// SPDX-License-Identifier: MIT
#include "attractor/kernels/seen_points.h"

#include "attractor/kernels/kernels.h"
#include "attractor/kernels/solid_walk.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "attractor/kernels/seen_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "attractor/kernels/vectors-inl.h" // for each target: behind foreach_target.h

HWY_BEFORE_NAMESPACE();
namespace attractor::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using kernels::PixelPoints;
using kernels::PointTolerance;

using Bits = hn::RebindToUnsigned<Float>;
using BitVector = hn::Vec<Bits>;

// Resolution of places in a pixel: 8 × 8, four rows of them in 32 bits.
constexpr float steps = 8;

// Ones from a bit on: 8·row, row ≤ 4, in two shifts that every instruction set has.
HWY_ATTR static HWY_INLINE BitVector fromRow(IntVector row) {
    const Bits du;
    const Int di;
    const IntVector inHalf = hn::Min(hn::Max(row, hn::Zero(di)), hn::Set(di, 4));
    const BitVector shift = hn::BitCast(du, hn::ShiftLeft<2>(inHalf));
    return hn::Shl(hn::Shl(hn::Set(du, ~0U), shift), shift);
}

struct Span {
    IntVector first, end;
};

// Steps of [0, 1] that are wholly within [low, high].
HWY_ATTR static HWY_INLINE Span stepsWithin(FloatVector low, FloatVector high) {
    const Float d;
    const Int di;
    const FloatVector zero = hn::Zero(d), scale = hn::Set(d, steps);
    const IntVector above = truncated(hn::Mul(hn::Max(low, zero), scale));
    const auto inside = hn::RebindMask(di, hn::Gt(low, zero));
    const IntVector first = hn::IfThenElse(inside, hn::Add(above, hn::Set(di, 1)), hn::Zero(di));
    return {first, truncated(hn::Mul(hn::Min(hn::Max(high, zero), hn::Set(d, 1)), scale))};
}

// The places in which one of the points at `from` hides the one at k.
HWY_ATTR static HWY_INLINE std::uint64_t hiddenAt(const PixelPoints& points, std::size_t k, std::size_t from,
                                                  const PointTolerance& tolerance) {
    const Float d;
    const Bits du;
    const FloatVector dx = hn::Sub(hn::LoadU(d, points.x + from), hn::Set(d, points.x[k]));
    const FloatVector dy = hn::Sub(hn::LoadU(d, points.y + from), hn::Set(d, points.y[k]));
    const FloatVector dz = hn::Sub(hn::Set(d, points.z[k]), hn::LoadU(d, points.z + from));
    const FloatVector absX = hn::Abs(dx), absY = hn::Abs(dy), across = hn::Add(absX, absY);
    const FloatVector deep = hn::Mul(hn::Set(d, tolerance.deep), dz);
    const FloatVector off =
        hn::Add(hn::Add(hn::Mul(hn::Set(d, tolerance.flat), across), deep), hn::Set(d, tolerance.pixels));
    const FloatVector nearer = hn::Sub(hn::Sub(dz, deep), hn::Mul(hn::Set(d, tolerance.deep), across));
    const FloatVector one = hn::Set(d, 1), room = hn::Sub(one, off);
    const auto hides =
        hn::And(hn::Ge(nearer, hn::Set(d, tolerance.depth)), hn::Lt(hn::Max(absX, absY), room));
    if (hn::AllFalse(d, hides)) return 0;
    const Span columns = stepsWithin(hn::Sub(off, dx), hn::Sub(room, dx));
    const Span rows = stepsWithin(hn::Sub(off, dy), hn::Sub(room, dy));
    const Int di;
    const BitVector bit = hn::Set(du, 1);
    const BitVector until = hn::Shl(bit, hn::BitCast(du, columns.end));
    const BitVector before = hn::Shl(bit, hn::BitCast(du, hn::Min(columns.first, columns.end)));
    BitVector places = hn::IfThenElseZero(hn::RebindMask(du, hides), hn::Sub(until, before));
    places = hn::Or(places, hn::ShiftLeft<8>(places));
    places = hn::Or(places, hn::ShiftLeft<16>(places));
    const IntVector four = hn::Set(di, 4);
    const BitVector upper = hn::AndNot(fromRow(rows.end), hn::And(places, fromRow(rows.first)));
    const BitVector lower =
        hn::AndNot(fromRow(hn::Sub(rows.end, four)), hn::And(places, fromRow(hn::Sub(rows.first, four))));
    alignas(64) std::uint32_t halves[2][kernels::solidLanes];
    hn::Store(upper, du, halves[0]);
    hn::Store(lower, du, halves[1]);
    std::uint64_t result = 0;
    for (std::size_t lane = 0; lane < hn::Lanes(du); ++lane)
        result |= static_cast<std::uint64_t>(halves[1][lane]) << 32 | halves[0][lane];
    return result;
}

HWY_ATTR void markSeen(const PixelPoints& points, const PointTolerance& tolerance,
                       std::uint8_t* HWY_RESTRICT seen) {
    const std::size_t lanes = hn::Lanes(Float());
    for (std::size_t k = 0; k < points.size; ++k) {
        std::uint64_t hidden = 0;
        // Points of almost equal depth move along with it.
        for (std::size_t from = k / lanes * lanes + lanes; from > 0 && ~hidden != 0; from -= lanes)
            hidden |= hiddenAt(points, k, from - lanes, tolerance);
        seen[k] = ~hidden != 0;
    }
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace attractor {

HWY_EXPORT(markSeen);

namespace kernels {

void markSeen(const PixelPoints& points, const PointTolerance& tolerance, std::uint8_t* seen) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(markSeen)(points, tolerance, seen);
}

} // namespace kernels
} // namespace attractor
#endif
