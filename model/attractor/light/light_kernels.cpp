// SPDX-License-Identifier: MIT
#include "attractor/light/light_kernels.h"

#include "attractor/kernels/depth_raster.h"

// SSSE3 alone would only make the program larger; vectors of unknown length cannot be members.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "attractor/light/light_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace attractor::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using kernels::emptyDepth;
using kernels::Lamps;
using kernels::Margins;
using kernels::Neighbours;
using kernels::occlusionRadii;
using kernels::OcclusionRadius;
using kernels::Ramp;

using Int = hn::CappedTag<std::int32_t, 16>;
using Float = hn::RebindToFloat<Int>;
using Unsigned = hn::RebindToUnsigned<Int>;
using IntVector = hn::Vec<Int>;
using FloatVector = hn::Vec<Float>;

HWY_ATTR static HWY_INLINE FloatVector numbers(float value) {
    return hn::Set(Float(), value);
}

// Calls work(first) for whole vectors. Buffers have room for the last one: see RowBuffer.
template <class Work> HWY_ATTR static HWY_INLINE void forVectors(std::size_t count, Work work) {
    for (std::size_t k = 0; k < count; k += hn::Lanes(Int()))
        work(k);
}

HWY_ATTR void depthCodes(const std::uint32_t* HWY_RESTRICT keys, std::size_t count,
                         std::int32_t* HWY_RESTRICT codes) {
    const Unsigned du;
    const Int di;
    const std::size_t n = hn::Lanes(di);
    const auto empty = hn::Set(du, emptyKey);
    std::size_t k = 0;
    for (; k + n <= count; k += n) {
        const auto key = hn::LoadU(du, keys + k);
        const IntVector code = hn::BitCast(di, hn::ShiftRight<8>(key));
        const auto isEmpty = hn::RebindMask(di, hn::Eq(key, empty));
        hn::StoreU(hn::IfThenElse(isEmpty, hn::Set(di, emptyDepth), code), di, codes + k);
    }
    for (; k < count; ++k)
        codes[k] = keys[k] == emptyKey ? emptyDepth : static_cast<std::int32_t>(keys[k] >> 8);
}

HWY_ATTR Margins emptyMargins(const std::uint32_t* keys, std::size_t count) {
    const Unsigned du;
    const std::size_t n = hn::Lanes(du);
    const auto empty = hn::Set(du, emptyKey);
    const auto areEmpty = [&](const std::uint32_t* from) HWY_ATTR {
        const auto first = hn::And(hn::LoadU(du, from), hn::LoadU(du, from + n));
        const auto second = hn::And(hn::LoadU(du, from + 2 * n), hn::LoadU(du, from + 3 * n));
        return hn::AllTrue(du, hn::Eq(hn::And(first, second), empty)); // empty keys have all bits set
    };
    Margins margins;
    while (margins.before + 4 * n <= count && areEmpty(keys + margins.before))
        margins.before += 4 * n;
    while (margins.before < count && keys[margins.before] == emptyKey)
        ++margins.before;
    if (margins.before == count) return {count, count};
    while (margins.after + 4 * n <= count && areEmpty(keys + (count - margins.after - 4 * n)))
        margins.after += 4 * n;
    while (keys[count - margins.after - 1] == emptyKey)
        ++margins.after;
    return margins;
}

HWY_ATTR void minimumOf3(const std::int32_t* a, const std::int32_t* b, const std::int32_t* c,
                         std::size_t count, std::int32_t* HWY_RESTRICT minimum) {
    const Int di;
    forVectors(count, [&](std::size_t k) HWY_ATTR {
        const IntVector two = hn::Min(hn::LoadU(di, a + k), hn::LoadU(di, b + k));
        hn::StoreU(hn::Min(two, hn::LoadU(di, c + k)), di, minimum + k);
    });
}

// Σ over the neighbours of (z − z_k) cut to [0, saturation], as 8 z − Σ z_k cut to [z − saturation, z].
HWY_ATTR static HWY_INLINE IntVector nearerBy(IntVector z, const Neighbours& at, std::size_t k,
                                              std::int32_t saturation) {
    const Int di;
    const IntVector lowest = hn::Sub(z, hn::Set(di, saturation));
    const auto cut = [&](const std::int32_t* from)
                         HWY_ATTR { return hn::Min(hn::Max(hn::LoadU(di, from), lowest), z); };
    const IntVector above =
        hn::Add(hn::Add(cut(at.above + k - at.step), cut(at.above + k)), cut(at.above + k + at.step));
    const IntVector below =
        hn::Add(hn::Add(cut(at.below + k - at.step), cut(at.below + k)), cut(at.below + k + at.step));
    const IntVector beside = hn::Add(cut(at.row + k - at.step), cut(at.row + k + at.step));
    return hn::Sub(hn::ShiftLeft<3>(z), hn::Add(hn::Add(above, below), beside));
}

// exp(−x) for x in [0, 4], to 1e-6: (the Taylor polynomial at x / 8)⁸.
HWY_ATTR static HWY_INLINE FloatVector exponentialOfMinus(FloatVector x) {
    const FloatVector y = hn::Mul(x, numbers(-1.0F / 8));
    FloatVector sum = numbers(1.0F / 5040);
    for (const float coefficient : {1.0F / 720, 1.0F / 120, 1.0F / 24, 1.0F / 6, 1.0F / 2, 1.0F, 1.0F})
        sum = hn::Add(hn::Mul(sum, y), numbers(coefficient));
    const FloatVector square = hn::Mul(sum, sum);
    const FloatVector fourth = hn::Mul(square, square);
    return hn::Mul(fourth, fourth);
}

HWY_ATTR void shades(const std::int32_t* HWY_RESTRICT codes,
                     const std::array<OcclusionRadius, occlusionRadii>& radii, std::size_t count,
                     float* HWY_RESTRICT shade) {
    const Int di;
    const Float df;
    const IntVector empty = hn::Set(di, emptyDepth);
    forVectors(count, [&](std::size_t k) HWY_ATTR {
        const IntVector z = hn::LoadU(di, codes + k);
        FloatVector exponent = hn::Zero(df);
        if (!hn::AllTrue(di, hn::Eq(z, empty)))
            for (const OcclusionRadius& radius : radii) {
                const IntVector response = nearerBy(z, radius.neighbours, k, radius.saturation);
                exponent = hn::Add(exponent, hn::Mul(hn::ConvertTo(df, response), numbers(radius.perCode)));
            }
        hn::StoreU(exponentialOfMinus(exponent), df, shade + k);
    });
}

// The difference of smaller magnitude between the steps `before` → `at` → `after`.
HWY_ATTR static HWY_INLINE FloatVector slope(IntVector before, IntVector at, IntVector after) {
    const Int di;
    const IntVector first = hn::Sub(at, before);
    const IntVector second = hn::Sub(after, at);
    const IntVector smaller = hn::IfThenElse(hn::Lt(hn::Abs(second), hn::Abs(first)), second, first);
    const auto known = hn::Lt(hn::Abs(smaller), hn::Set(di, emptyDepth / 2));
    return hn::ConvertTo(Float(), hn::IfThenElseZero(known, smaller));
}

HWY_ATTR void slopes(const Neighbours& at, float scale, std::size_t count, float* HWY_RESTRICT right,
                     float* HWY_RESTRICT up) {
    const Int di;
    const Float df;
    const FloatVector pixels = numbers(scale);
    forVectors(count, [&](std::size_t k) HWY_ATTR {
        const IntVector z = hn::LoadU(di, at.row + k);
        const FloatVector across =
            slope(hn::LoadU(di, at.row + k - at.step), z, hn::LoadU(di, at.row + k + at.step));
        const FloatVector along = slope(hn::LoadU(di, at.below + k), z, hn::LoadU(di, at.above + k));
        hn::StoreU(hn::Mul(across, pixels), df, right + k);
        hn::StoreU(hn::Mul(along, pixels), df, up + k);
    });
}

// 1/√x for x ≥ 1, to 5e-6, by steps that every machine rounds alike.
HWY_ATTR static HWY_INLINE FloatVector inverseRoot(FloatVector x) {
    const Int di;
    const IntVector guess = hn::Sub(hn::Set(di, 0x5f3759df), hn::ShiftRight<1>(hn::BitCast(di, x)));
    const FloatVector half = hn::Mul(x, numbers(0.5F));
    FloatVector root = hn::BitCast(Float(), guess);
    for (int step = 0; step < 2; ++step) {
        const FloatVector error = hn::Mul(half, hn::Mul(root, root));
        root = hn::Mul(root, hn::Sub(numbers(1.5F), error));
    }
    return root;
}

HWY_ATTR void illuminate(const float* HWY_RESTRICT right, const float* HWY_RESTRICT up,
                         const float* HWY_RESTRICT shade, const Lamps& lamps, std::size_t count,
                         float* HWY_RESTRICT light) {
    const Float df;
    const FloatVector one = numbers(1), half = numbers(0.5F);
    const FloatVector limit = numbers(1e6F); // limit of distinguishable slopes, whose squares are finite
    const auto halfLambert = [&](FloatVector cosine) HWY_ATTR {
        const FloatVector wrapped = hn::Add(hn::Mul(cosine, half), half);
        return hn::Mul(wrapped, wrapped);
    };
    forVectors(count, [&](std::size_t k) HWY_ATTR {
        const FloatVector p = hn::Min(hn::Max(hn::LoadU(df, right + k), hn::Neg(limit)), limit);
        const FloatVector q = hn::Min(hn::Max(hn::LoadU(df, up + k), hn::Neg(limit)), limit);
        const FloatVector square = hn::Add(hn::Add(hn::Mul(p, p), hn::Mul(q, q)), one);
        const FloatVector facing = hn::Min(inverseRoot(square), one);
        const FloatVector along =
            hn::Add(hn::Add(hn::Mul(p, numbers(lamps.key.right)), hn::Mul(q, numbers(lamps.key.up))),
                    numbers(lamps.key.towards));
        const FloatVector cosine = hn::Min(hn::Max(hn::Mul(along, facing), numbers(-1)), one);
        const FloatVector head = hn::Mul(halfLambert(facing), numbers(lamps.headShare));
        const FloatVector key = hn::Mul(halfLambert(cosine), numbers(1 - lamps.headShare));
        hn::StoreU(hn::Min(hn::Mul(hn::Add(head, key), hn::LoadU(df, shade + k)), one), df, light + k);
    });
}

HWY_ATTR void paint(const std::int32_t* HWY_RESTRICT codes, const float* HWY_RESTRICT light,
                    const std::int32_t* HWY_RESTRICT tints, const Ramp& ramp, std::size_t count,
                    std::uint32_t* HWY_RESTRICT pixels) {
    const Int di;
    const Float df;
    const std::size_t n = hn::Lanes(di);
    const IntVector empty = hn::Set(di, emptyDepth),
                    nothing = hn::Set(di, static_cast<std::int32_t>(ramp.ground));
    const FloatVector last = numbers(static_cast<float>(ramp.levels - 1)), half = numbers(0.5F);
    const auto* colours = reinterpret_cast<const std::int32_t*>(ramp.colours);
    const auto pixelsAt = [&](std::size_t k) HWY_ATTR {
        const auto isEmpty = hn::Eq(hn::LoadU(di, codes + k), empty);
        if (hn::AllTrue(di, isEmpty)) return nothing;
        const IntVector level = hn::ConvertTo(di, hn::Add(hn::Mul(hn::LoadU(df, light + k), last), half));
        const IntVector tint = hn::Mul(hn::LoadU(di, tints + k), hn::Set(di, ramp.levels));
        return hn::IfThenElse(isEmpty, nothing, hn::GatherIndex(di, colours, hn::Add(tint, level)));
    };
    auto* out = reinterpret_cast<std::int32_t*>(pixels);
    std::size_t k = 0;
    for (; k + n <= count; k += n)
        hn::StoreU(pixelsAt(k), di, out + k);
    if (k == count) return;
    HWY_ALIGN std::int32_t rest[16];
    hn::Store(pixelsAt(k), di, rest);
    for (std::size_t i = 0; k + i < count; ++i)
        out[k + i] = rest[i];
}

HWY_ATTR void addFog(const std::int32_t* HWY_RESTRICT codes, const std::int32_t* HWY_RESTRICT clear,
                     std::uint32_t ground, std::size_t count, std::uint32_t* HWY_RESTRICT pixels) {
    const Int di;
    const Unsigned du;
    const std::size_t n = hn::Lanes(di);
    const IntVector last = hn::Set(di, static_cast<std::int32_t>(kernels::fogSize - 1));
    const auto byte = hn::Set(du, 255U), half = hn::Set(du, kernels::fullClear / 2);
    const auto full = hn::Set(du, static_cast<std::uint32_t>(kernels::fullClear));
    const auto mixed = [&](auto pixel, const std::int32_t* at) HWY_ATTR {
        const IntVector code = hn::ShiftRight<kernels::fogShift>(hn::LoadU(di, at));
        const auto share = hn::BitCast(du, hn::GatherIndex(di, clear, hn::Min(code, last)));
        const auto rest = hn::Sub(full, share);
        auto result = hn::Zero(du);
        for (int shift = 0; shift < 32; shift += 8) {
            const auto front = hn::And(hn::ShiftRightSame(pixel, shift), byte);
            const auto back = hn::Set(du, ground >> shift & 255U);
            const auto sum = hn::Add(hn::Add(hn::Mul(front, share), hn::Mul(back, rest)), half);
            result = hn::Or(result, hn::ShiftLeftSame(hn::ShiftRight<12>(sum), shift));
        }
        return result;
    };
    std::size_t k = 0;
    for (; k + n <= count; k += n)
        hn::StoreU(mixed(hn::LoadU(du, pixels + k), codes + k), du, pixels + k);
    if (k == count) return;
    HWY_ALIGN std::uint32_t rest[16] = {};
    for (std::size_t i = 0; k + i < count; ++i)
        rest[i] = pixels[k + i];
    hn::Store(mixed(hn::Load(du, rest), codes + k), du, rest);
    for (std::size_t i = 0; k + i < count; ++i)
        pixels[k + i] = rest[i];
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace attractor {

HWY_EXPORT(depthCodes);
HWY_EXPORT(emptyMargins);
HWY_EXPORT(minimumOf3);
HWY_EXPORT(shades);
HWY_EXPORT(slopes);
HWY_EXPORT(illuminate);
HWY_EXPORT(paint);
HWY_EXPORT(addFog);

namespace kernels {

void depthCodes(const std::uint32_t* keys, std::size_t count, std::int32_t* codes) {
    HWY_DYNAMIC_DISPATCH(depthCodes)(keys, count, codes);
}

Margins emptyMargins(const std::uint32_t* keys, std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(emptyMargins)(keys, count);
}

void minimumOf3(const std::int32_t* a, const std::int32_t* b, const std::int32_t* c, std::size_t count,
                std::int32_t* minimum) {
    HWY_DYNAMIC_DISPATCH(minimumOf3)(a, b, c, count, minimum);
}

void shades(const std::int32_t* codes, const std::array<OcclusionRadius, occlusionRadii>& radii,
            std::size_t count, float* shade) {
    HWY_DYNAMIC_DISPATCH(shades)(codes, radii, count, shade);
}

void slopes(const Neighbours& neighbours, float scale, std::size_t count, float* right, float* up) {
    HWY_DYNAMIC_DISPATCH(slopes)(neighbours, scale, count, right, up);
}

void illuminate(const float* right, const float* up, const float* shade, const Lamps& lamps,
                std::size_t count, float* light) {
    HWY_DYNAMIC_DISPATCH(illuminate)(right, up, shade, lamps, count, light);
}

void paint(const std::int32_t* codes, const float* light, const std::int32_t* tints, const Ramp& ramp,
           std::size_t count, std::uint32_t* pixels) {
    HWY_DYNAMIC_DISPATCH(paint)(codes, light, tints, ramp, count, pixels);
}

void addFog(const std::int32_t* codes, const std::int32_t* clear, std::uint32_t ground, std::size_t count,
            std::uint32_t* pixels) {
    HWY_DYNAMIC_DISPATCH(addFog)(codes, clear, ground, count, pixels);
}

} // namespace kernels
} // namespace attractor
#endif
