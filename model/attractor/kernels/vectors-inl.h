// SPDX-License-Identifier: MIT
// Compiled once for each instruction set: no include guard but Highway's own.
#if defined(BARYCAGE_VECTORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BARYCAGE_VECTORS_INL_H_
#undef BARYCAGE_VECTORS_INL_H_
#else
#define BARYCAGE_VECTORS_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace attractor::HWY_NAMESPACE {

// Vectors of at most 16 lanes, so that 128 points are whole vectors for every instruction set.
using Float = hwy::HWY_NAMESPACE::CappedTag<float, 16>;
using Int = hwy::HWY_NAMESPACE::RebindToSigned<Float>;
using FloatVector = hwy::HWY_NAMESPACE::Vec<Float>;
using IntVector = hwy::HWY_NAMESPACE::Vec<Int>;

// Truncates numbers in [0, 2³¹), which need none of the care that a general conversion takes.
HWY_ATTR static HWY_INLINE IntVector truncated(FloatVector value) {
#if HWY_TARGET == HWY_AVX3
    return IntVector{_mm512_cvttps_epi32(value.raw)};
#elif HWY_TARGET == HWY_AVX2
    return IntVector{_mm256_cvttps_epi32(value.raw)};
#elif HWY_TARGET == HWY_SSE4
    return IntVector{_mm_cvttps_epi32(value.raw)};
#else
    return hwy::HWY_NAMESPACE::ConvertTo(Int(), value);
#endif
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
