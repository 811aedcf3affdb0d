// SPDX-License-Identifier: MIT
#include "attractor/kernels/picture_mix.h"

#include "attractor/kernels/kernels.h"

#include <algorithm>
#include <array>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "attractor/kernels/picture_mix.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace attractor::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using kernels::PictureLevel;
using kernels::PicturePlace;

constexpr std::int64_t fraction = (1 << kernels::placeBits) - 1;

// Two pixels side by side: eight channels.
#if HWY_TARGET == HWY_SCALAR
using Pixels = std::array<std::int16_t, 8>;

static Pixels pixelsAt(const std::int16_t* from) {
    Pixels pixels;
    std::copy_n(from, pixels.size(), pixels.begin());
    return pixels;
}

static Pixels between(const Pixels& a, const Pixels& b, std::int64_t share) {
    Pixels result;
    for (std::size_t k = 0; k < result.size(); ++k) {
        const std::int64_t step = ((b[k] - a[k]) * share + (1 << 14)) >> kernels::placeBits;
        result[k] = static_cast<std::int16_t>(a[k] + step);
    }
    return result;
}

static Pixels right(const Pixels& pixels) {
    return {pixels[4], pixels[5], pixels[6], pixels[7]};
}

static void store(const Pixels& pixels, std::int16_t* to) {
    std::copy_n(pixels.begin(), 4, to);
}
#else
using Channels = hn::FixedTag<std::int16_t, 8>;
using Pixels = hn::Vec<Channels>;

HWY_ATTR static HWY_INLINE Pixels pixelsAt(const std::int16_t* from) {
    return hn::LoadU(Channels(), from);
}

HWY_ATTR static HWY_INLINE Pixels between(Pixels a, Pixels b, std::int64_t share) {
    const Pixels factor = hn::Set(Channels(), static_cast<std::int16_t>(share));
    return hn::Add(a, hn::MulFixedPoint15(hn::Sub(b, a), factor));
}

HWY_ATTR static HWY_INLINE Pixels right(Pixels pixels) {
    return hn::ShiftRightLanes<4>(Channels(), pixels);
}

HWY_ATTR static HWY_INLINE void store(Pixels pixels, std::int16_t* to) {
    const hn::Half<Channels> left;
    hn::StoreU(hn::LowerHalf(left, pixels), left, to);
}
#endif

// The coordinate relative to the middle of the first pixel, limited to that of the last.
HWY_ATTR static HWY_INLINE std::int64_t fromMiddle(std::int64_t at, std::int32_t size) {
    constexpr std::int64_t half = std::int64_t{1} << (kernels::placeBits - 1);
    const std::int64_t last = static_cast<std::int64_t>(size - 1) << kernels::placeBits;
    const std::int64_t from = at - half;
    return from < 0 ? 0 : from > last ? last : from;
}

// Interpolates the four nearest pixels; only the left lane of the result is valid.
HWY_ATTR static HWY_INLINE Pixels smooth(const std::int16_t* channels, const PictureLevel& level,
                                         std::int64_t x, std::int64_t y) {
    const std::int64_t column = fromMiddle(x, level.columns), row = fromMiddle(y, level.rows);
    const std::int64_t stride = 4 * (static_cast<std::int64_t>(level.columns) + 1);
    const std::int16_t* from =
        channels + level.first + (row >> kernels::placeBits) * stride + 4 * (column >> kernels::placeBits);
    const Pixels both = between(pixelsAt(from), pixelsAt(from + stride), row & fraction);
    return between(both, right(both), column & fraction);
}

HWY_ATTR void mixPicture(const std::int16_t* HWY_RESTRICT channels, const PictureLevel* HWY_RESTRICT levels,
                         const PicturePlace* HWY_RESTRICT places, std::size_t count,
                         std::int16_t* HWY_RESTRICT mixed) {
    for (std::size_t k = 0; k < count; ++k) {
        const PicturePlace& at = places[k];
        const int fine = at.level >> kernels::placeBits;
        const std::int64_t share = at.level & fraction;
        Pixels result = smooth(channels, levels[fine], at.x >> fine, at.y >> fine);
        if (share != 0) {
            const int coarse = fine + 1;
            result = between(result, smooth(channels, levels[coarse], at.x >> coarse, at.y >> coarse), share);
        }
        store(result, mixed + 4 * k);
    }
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace attractor::kernels {

HWY_EXPORT(mixPicture);

void mixPicture(const std::int16_t* channels, const PictureLevel* levels, const PicturePlace* places,
                std::size_t count, std::int16_t* mixed) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(mixPicture)(channels, levels, places, count, mixed);
}

} // namespace attractor::kernels
#endif
