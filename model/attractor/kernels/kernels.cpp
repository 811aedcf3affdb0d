// SPDX-License-Identifier: MIT
#include "attractor/kernels/kernels.h"

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

// SSSE3 alone would only make the program larger; vectors of unknown length cannot be members.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "attractor/kernels/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "attractor/kernels/vectors-inl.h" // for each target: behind foreach_target.h

HWY_BEFORE_NAMESPACE();
namespace attractor::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using kernels::ChaosTables;
using kernels::chunk;
using kernels::Lanes;
using kernels::Patch;
using kernels::Run;

using Unsigned = hn::RebindToUnsigned<Float>;
using UnsignedVector = hn::Vec<Unsigned>;

HWY_ATTR static HWY_INLINE FloatVector affine(FloatVector a, FloatVector b, FloatVector c, FloatVector x,
                                              FloatVector y) {
    return hn::Add(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), c); // never fused: see the test of equal counts
}

// A coordinate of camera·cage·w_σ in every lane: x·a + y·b + constant.
struct Linear {
    FloatVector x, y, constant;

    HWY_ATTR Linear(float a, float b, float c)
        : x(hn::Set(Float(), a)), y(hn::Set(Float(), b)), constant(hn::Set(Float(), c)) {}
    HWY_ATTR HWY_INLINE FloatVector operator()(FloatVector a, FloatVector b) const {
        return affine(x, y, constant, a, b);
    }
};

// The same with terms of second order: (x + aa·a + ab·b)·a + (y + bb·b)·b + constant.
struct Quadratic {
    Linear linear;
    FloatVector aa, ab, bb;

    HWY_ATTR Quadratic(const Linear& l, float p, float q, float r)
        : linear(l), aa(hn::Set(Float(), p)), ab(hn::Set(Float(), q)), bb(hn::Set(Float(), r)) {}
    HWY_ATTR HWY_INLINE FloatVector operator()(FloatVector a, FloatVector b) const {
        const FloatVector alongA = affine(aa, ab, linear.x, a, b);
        const FloatVector alongB = hn::Add(hn::Mul(bb, b), linear.y);
        return affine(alongA, alongB, linear.constant, a, b);
    }
};

struct Placement {
    Linear column, row;

    HWY_ATTR explicit Placement(const Word& word)
        : column(word.xx, word.xy, word.x), row(word.yx, word.yy, word.y) {}
};

struct CurvedPlacement {
    Quadratic column, row;

    HWY_ATTR CurvedPlacement(const Word& word, const Curve& curve)
        : column({word.xx, word.xy, word.x}, curve.xaa, curve.xab, curve.xbb),
          row({word.yx, word.yy, word.y}, curve.yaa, curve.yab, curve.ybb) {}
};

// Cell (column, row) of a grid has the number row·stride + column − origin.
struct Numbering {
    IntVector stride;
    IntVector origin; // may have overflowed, like the product

    HWY_ATTR Numbering(int width, int firstColumn, int firstRow)
        : stride(hn::Set(Int(), width)),
          origin(hn::Set(Int(), static_cast<std::int32_t>(static_cast<std::uint32_t>(firstRow) *
                                                              static_cast<std::uint32_t>(width) +
                                                          static_cast<std::uint32_t>(firstColumn)))) {}
    HWY_ATTR HWY_INLINE IntVector cell(FloatVector column, FloatVector row) const {
        return hn::Sub(hn::Add(hn::Mul(truncated(row), stride), truncated(column)), origin);
    }
};

// The cells of points that all lie in the grid.
template <class AnyPlacement> struct CellsInside {
    AnyPlacement placement;
    Numbering grid;

    HWY_ATTR HWY_INLINE IntVector operator()(FloatVector x, FloatVector y, std::size_t) const {
        return grid.cell(placement.column(x, y), placement.row(x, y));
    }
};

// The same wherever they lie: overflow cells for those outside the window.
template <class AnyPlacement> struct CellsAnywhere {
    AnyPlacement placement;
    Numbering grid;
    FloatVector width, first, end;
    IntVector overflow;

    HWY_ATTR CellsAnywhere(const AnyPlacement& p, const CellWindow& window)
        : placement(p),
          grid(window.width, 0, window.firstRow),
          width(hn::Set(Float(), static_cast<float>(window.width))),
          first(hn::Set(Float(), static_cast<float>(window.firstRow))),
          end(hn::Set(Float(), static_cast<float>(window.endRow))),
          overflow(hn::Iota(Int(), static_cast<std::int32_t>(window.cells()))) {}

    HWY_ATTR HWY_INLINE IntVector operator()(FloatVector x, FloatVector y, std::size_t k) const {
        const FloatVector column = placement.column(x, y);
        const FloatVector row = placement.row(x, y);
        const auto inside = hn::And(hn::And(hn::Ge(column, hn::Zero(Float())), hn::Lt(column, width)),
                                    hn::And(hn::Ge(row, first), hn::Lt(row, end)));
        const IntVector cell =
            grid.cell(hn::IfThenElseZero(inside, column), hn::IfThenElse(inside, row, first));
        const IntVector outside =
            hn::Add(overflow, hn::Set(Int(), static_cast<std::int32_t>(k % overflowCells)));
        return hn::IfThenElse(hn::RebindMask(Int(), inside), cell, outside);
    }
};

// Calls add(cell, k) for every point of the run, k counted within its chunk. While the cells of one chunk are
// added to, those of the next are computed: an addition waits for memory, which leaves the arithmetic idle.
template <class CellsAt, class Add>
HWY_ATTR static HWY_INLINE void forCells(const CellsAt& cellsAt, const Run& run, const Add& add) {
    const Float d;
    constexpr std::size_t lanes = hn::MaxLanes(Float());
    constexpr std::size_t together = lanes < 8 ? 8 : lanes;
    alignas(64) std::uint32_t cells[2 * chunk];
    const auto compute = [&](std::size_t point, std::size_t k, std::uint32_t* out) HWY_ATTR {
        hn::Store(cellsAt(hn::LoadU(d, run.x + point), hn::LoadU(d, run.y + point), k), Int(),
                  reinterpret_cast<std::int32_t*>(out));
    };
    const auto computeChunk = [&](std::size_t first, std::uint32_t* out) HWY_ATTR {
        const std::size_t count = run.count - first < chunk ? run.count - first : chunk;
        for (std::size_t k = 0; k < count; k += lanes)
            compute(first + k, k, out + k);
    };
    const auto addAll = [&](const std::uint32_t* HWY_RESTRICT from, std::size_t count) HWY_ATTR {
        for (std::size_t k = 0; k < count; ++k)
            add(from[k], k);
    };
    std::uint32_t* present = cells;
    std::uint32_t* next = cells + chunk;
    std::size_t done = 0;
    computeChunk(0, present);
    for (; run.count - done >= 2 * chunk; done += chunk) {
        for (std::size_t k = 0; k < chunk; k += together) {
            std::uint64_t pairs[together / 2]; // half the number of loads
            for (std::size_t p = 0; p < together / 2; ++p)
                std::memcpy(&pairs[p], present + k + 2 * p, sizeof pairs[p]);
            for (std::size_t lane = 0; lane < together; lane += lanes)
                compute(done + chunk + k + lane, k + lane, next + k + lane);
            for (std::size_t p = 0; p < together / 2; ++p) {
                add(static_cast<std::uint32_t>(pairs[p]), 2 * p);
                add(pairs[p] >> 32, 2 * p + 1);
            }
        }
        std::swap(present, next);
    }
    if (run.count - done > chunk) {
        computeChunk(done + chunk, next);
        addAll(present, chunk);
        std::swap(present, next);
        done += chunk;
    }
    addAll(present, run.count - done);
}

template <class CellsAt>
HWY_ATTR static HWY_INLINE void addToCountsAt(const CellsAt& cellsAt, const Run& run,
                                              std::uint32_t* HWY_RESTRICT counts) {
    forCells(cellsAt, run, [counts](std::size_t cell, std::size_t) HWY_ATTR { ++counts[cell]; });
}

HWY_ATTR void addToCounts(const ShownWord& shown, const Run& run, const CellWindow& window,
                          std::uint32_t* HWY_RESTRICT counts) {
    if (shown.curve == nullptr)
        addToCountsAt(CellsAnywhere(Placement(shown.word), window), run, counts);
    else
        addToCountsAt(CellsAnywhere(CurvedPlacement(shown.word, *shown.curve), window), run, counts);
}

HWY_ATTR void addInside(const ShownWord& shown, const Run& run, const CellWindow& window,
                        std::uint32_t* HWY_RESTRICT counts) {
    const Numbering grid(window.width, 0, window.firstRow);
    if (shown.curve == nullptr)
        addToCountsAt(CellsInside<Placement>{Placement(shown.word), grid}, run, counts);
    else
        addToCountsAt(CellsInside<CurvedPlacement>{CurvedPlacement(shown.word, *shown.curve), grid}, run,
                      counts);
}

HWY_ATTR void addToPatch(const Word& word, const Run& run, const Patch& patch, const CellWindow& window,
                         std::uint32_t* HWY_RESTRICT counts) {
    constexpr std::size_t copies = 8;
    alignas(64) std::uint32_t small[copies][kernels::patchCells];
    const auto size = static_cast<std::size_t>(patch.width) * static_cast<std::size_t>(patch.height);
    for (auto& copy : small)
        std::memset(copy, 0, size * sizeof(std::uint32_t));
    const CellsInside<Placement> cellsAt{Placement(word), {patch.width, patch.column, patch.row}};
    forCells(cellsAt, run, [&small](std::size_t cell, std::size_t k) HWY_ATTR { ++small[k % copies][cell]; });
    for (int row = 0; row < patch.height; ++row) {
        std::uint32_t* out = counts +
                             static_cast<std::size_t>(patch.row + row - window.firstRow) *
                                 static_cast<std::size_t>(window.width) +
                             static_cast<std::size_t>(patch.column);
        const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(patch.width);
        for (std::size_t column = 0; column < static_cast<std::size_t>(patch.width); ++column)
            for (const auto& copy : small)
                out[column] += copy[at + column];
    }
}

// A cell holds four sums, which are added together where there are vectors.
#if HWY_TARGET == HWY_SCALAR
struct ColourSum {
    ColourCell weight;
    std::uint32_t seen = 0;

    explicit ColourSum(const ColourCell& colour) : weight(colour) {}
    void addTo(ColourCell& cell) {
        cell.samples += weight.samples;
        cell.red += weight.red;
        cell.green += weight.green;
        cell.blue += weight.blue;
        seen |= cell.samples | cell.red | cell.green | cell.blue;
    }
    std::uint32_t bits() const { return seen; }
};
#else
struct ColourSum {
    using Four = hn::Full128<std::uint32_t>;
    hn::Vec<Four> weight;
    hn::Vec<Four> seen;

    HWY_ATTR explicit ColourSum(const ColourCell& colour)
        : weight(hn::Load(Four(), &colour.samples)), seen(hn::Zero(Four())) {}
    HWY_ATTR HWY_INLINE void addTo(ColourCell& cell) {
        const auto sum = hn::Add(hn::Load(Four(), &cell.samples), weight);
        hn::Store(sum, Four(), &cell.samples);
        seen = hn::Or(seen, sum);
    }
    HWY_ATTR std::uint32_t bits() const {
        alignas(16) std::uint32_t parts[4];
        hn::Store(seen, Four(), parts);
        return parts[0] | parts[1] | parts[2] | parts[3];
    }
};
#endif

template <class CellsAt>
HWY_ATTR static HWY_INLINE std::uint32_t addToColoursAt(const CellsAt& cellsAt, const Run& run,
                                                        const ColourCell& colour,
                                                        ColourCell* HWY_RESTRICT sums) {
    ColourSum sum(colour);
    forCells(cellsAt, run, [&sum, sums](std::size_t cell, std::size_t) HWY_ATTR { sum.addTo(sums[cell]); });
    return sum.bits();
}

HWY_ATTR std::uint32_t addToColours(const ShownWord& shown, const Run& run, const CellWindow& window,
                                    const ColourCell& colour, ColourCell* HWY_RESTRICT sums) {
    if (shown.curve == nullptr)
        return addToColoursAt(CellsAnywhere(Placement(shown.word), window), run, colour, sums);
    return addToColoursAt(CellsAnywhere(CurvedPlacement(shown.word, *shown.curve), window), run, colour,
                          sums);
}

HWY_ATTR std::uint32_t addToColoursInside(const ShownWord& shown, const Run& run, const CellWindow& window,
                                          const ColourCell& colour, ColourCell* HWY_RESTRICT sums) {
    const Numbering grid(window.width, 0, window.firstRow);
    if (shown.curve == nullptr)
        return addToColoursAt(CellsInside<Placement>{Placement(shown.word), grid}, run, colour, sums);
    return addToColoursAt(CellsInside<CurvedPlacement>{CurvedPlacement(shown.word, *shown.curve), grid}, run,
                          colour, sums);
}

// Tables whose length is a power of two. Of an index only the bits count that tell their entries apart.
enum class Lookup { Registers16, Registers32, Gather };

template <Lookup how, class D> struct Table {
    using T = hn::TFromD<D>;
    const T* values;
    IntVector bits;

    HWY_ATTR Table(const T* v, std::size_t size)
        : values(v), bits(hn::Set(Int(), static_cast<std::int32_t>(size - 1))) {}
    HWY_ATTR HWY_INLINE hn::Vec<D> operator()(IntVector index) const {
        return hn::GatherIndex(D(), values, hn::And(index, bits));
    }
};

#if HWY_TARGET == HWY_AVX3
template <class D> struct Table<Lookup::Registers16, D> {
    __m512i all;

    HWY_ATTR Table(const hn::TFromD<D>* v, std::size_t) : all(_mm512_loadu_si512(v)) {}
    HWY_ATTR HWY_INLINE hn::Vec<D> operator()(IntVector index) const {
        return hn::BitCast(D(), IntVector{_mm512_permutexvar_epi32(index.raw, all)});
    }
};
template <class D> struct Table<Lookup::Registers32, D> {
    __m512i low;
    __m512i high;

    HWY_ATTR Table(const hn::TFromD<D>* v, std::size_t)
        : low(_mm512_loadu_si512(v)), high(_mm512_loadu_si512(v + 16)) {}
    HWY_ATTR HWY_INLINE hn::Vec<D> operator()(IntVector index) const {
        return hn::BitCast(D(), IntVector{_mm512_permutex2var_epi32(low, index.raw, high)});
    }
};
#elif HWY_TARGET == HWY_AVX2
template <class D> struct Table<Lookup::Registers16, D> {
    __m256 low;
    __m256 high;

    HWY_ATTR explicit Table(const hn::TFromD<D>* v, std::size_t)
        : low(_mm256_loadu_ps(reinterpret_cast<const float*>(v))),
          high(_mm256_loadu_ps(reinterpret_cast<const float*>(v) + 8)) {}
    HWY_ATTR HWY_INLINE hn::Vec<D> operator()(IntVector index) const {
        const __m256 upper = _mm256_castsi256_ps(_mm256_slli_epi32(index.raw, 28)); // sign bit
        return hn::BitCast(D(),
                           FloatVector{_mm256_blendv_ps(_mm256_permutevar8x32_ps(low, index.raw),
                                                        _mm256_permutevar8x32_ps(high, index.raw), upper)});
    }
};
// Four registers' worth for every table: more than there are, but a load each is less than a gather.
template <class D> struct Table<Lookup::Registers32, D> {
    Table<Lookup::Registers16, D> low;
    Table<Lookup::Registers16, D> high;

    HWY_ATTR explicit Table(const hn::TFromD<D>* v, std::size_t) : low(v, 16), high(v + 16, 16) {}
    HWY_ATTR HWY_INLINE hn::Vec<D> operator()(IntVector index) const {
        const __m256 upper = _mm256_castsi256_ps(_mm256_slli_epi32(index.raw, 27)); // sign bit
        const auto bits = [](hn::Vec<D> values) HWY_ATTR { return hn::BitCast(Float(), values).raw; };
        return hn::BitCast(D(), FloatVector{_mm256_blendv_ps(bits(low(index)), bits(high(index)), upper)});
    }
};
#endif

HWY_ATTR static HWY_INLINE UnsignedVector nextRandom(UnsignedVector& s0, UnsignedVector& s1,
                                                     UnsignedVector& s2, UnsignedVector& s3) {
    const UnsignedVector result = hn::Add(hn::RotateRight<25>(hn::Add(s0, s3)), s0);
    const UnsignedVector shifted = hn::ShiftLeft<9>(s1);
    s2 = hn::Xor(s2, s0);
    s3 = hn::Xor(s3, s1);
    s1 = hn::Xor(s1, s2);
    s0 = hn::Xor(s0, s3);
    s2 = hn::Xor(s2, shifted);
    s3 = hn::RotateRight<21>(s3);
    return result;
}

template <Lookup how, kernels::Guard guard>
HWY_ATTR static void iterateWith(Lanes& lanes, const ChaosTables& tables, std::size_t steps, float* outX,
                                 float* outY) {
    const Float d;
    const Int di;
    const Unsigned du;
    const Table<how, Int> threshold(tables.threshold, tables.size);
    const Table<how, Int> alias(tables.alias, tables.size);
    const Table<how, Float> a(tables.coefficients[0], tables.size);
    const Table<how, Float> b(tables.coefficients[1], tables.size);
    const Table<how, Float> c(tables.coefficients[2], tables.size);
    const Table<how, Float> dd(tables.coefficients[3], tables.size);
    const Table<how, Float> e(tables.coefficients[4], tables.size);
    const Table<how, Float> f(tables.coefficients[5], tables.size);
    const FloatVector radius = hn::Set(d, tables.escapeRadius);
    constexpr std::size_t together = 4; // independent orbits hide each other's latency
    const std::size_t n = hn::Lanes(d);
    for (std::size_t first = 0; first < Lanes::count; first += together * n) {
        UnsignedVector s0[together], s1[together], s2[together], s3[together];
        FloatVector x[together], y[together];
        for (std::size_t g = 0; g < together; ++g) {
            const std::size_t at = first + g * n;
            s0[g] = hn::Load(du, lanes.random[0].data() + at);
            s1[g] = hn::Load(du, lanes.random[1].data() + at);
            s2[g] = hn::Load(du, lanes.random[2].data() + at);
            s3[g] = hn::Load(du, lanes.random[3].data() + at);
            x[g] = hn::Load(d, lanes.x.data() + at);
            y[g] = hn::Load(d, lanes.y.data() + at);
        }
        for (std::size_t step = 0; step < steps; ++step) {
            for (std::size_t g = 0; g < together; ++g) {
                const IntVector random = hn::BitCast(di, nextRandom(s0[g], s1[g], s2[g], s3[g]));
                const IntVector map =
                    hn::IfThenElse(hn::Lt(random, threshold(random)), random, alias(random));
                const FloatVector nextX = affine(a(map), b(map), e(map), x[g], y[g]);
                const FloatVector nextY = affine(c(map), dd(map), f(map), x[g], y[g]);
                if constexpr (guard == kernels::Guard::On) {
                    const auto near = hn::And(hn::Lt(hn::Abs(nextX), radius), hn::Lt(hn::Abs(nextY), radius));
                    x[g] = hn::IfThenElseZero(near, nextX);
                    y[g] = hn::IfThenElseZero(near, nextY);
                } else {
                    x[g] = nextX;
                    y[g] = nextY;
                }
                if (outX != nullptr) {
                    hn::StoreU(x[g], d, outX + step * Lanes::count + first + g * n);
                    hn::StoreU(y[g], d, outY + step * Lanes::count + first + g * n);
                }
            }
        }
        for (std::size_t g = 0; g < together; ++g) {
            const std::size_t at = first + g * n;
            hn::Store(s0[g], du, lanes.random[0].data() + at);
            hn::Store(s1[g], du, lanes.random[1].data() + at);
            hn::Store(s2[g], du, lanes.random[2].data() + at);
            hn::Store(s3[g], du, lanes.random[3].data() + at);
            hn::Store(x[g], d, lanes.x.data() + at);
            hn::Store(y[g], d, lanes.y.data() + at);
        }
    }
}

template <kernels::Guard guard>
HWY_ATTR static void iterateGuarded(Lanes& lanes, const ChaosTables& tables, std::size_t steps, float* x,
                                    float* y) {
    if (tables.size == 16)
        iterateWith<Lookup::Registers16, guard>(lanes, tables, steps, x, y);
    else if (tables.size == 32)
        iterateWith<Lookup::Registers32, guard>(lanes, tables, steps, x, y);
    else
        iterateWith<Lookup::Gather, guard>(lanes, tables, steps, x, y);
}

HWY_ATTR void iterate(Lanes& lanes, const ChaosTables& tables, kernels::Guard guard, std::size_t steps,
                      float* x, float* y) {
    if (guard == kernels::Guard::Off)
        iterateGuarded<kernels::Guard::Off>(lanes, tables, steps, x, y);
    else
        iterateGuarded<kernels::Guard::On>(lanes, tables, steps, x, y);
}

// Bits 17 … 30 of a number as float: exponent and 6 digits of the mantissa.
constexpr std::int32_t toneBias = ((127 + 7) << 6) - static_cast<std::int32_t>(kernels::exactCounts);

HWY_ATTR static HWY_INLINE IntVector toneIndices(IntVector samples) {
    const Int di;
    const IntVector steps =
        hn::Sub(hn::ShiftRight<17>(hn::BitCast(di, hn::ConvertTo(Float(), samples))), hn::Set(di, toneBias));
    return hn::IfThenElse(hn::Lt(samples, hn::Set(di, static_cast<std::int32_t>(kernels::exactCounts))),
                          samples, steps);
}

HWY_ATTR void mapTones(const std::uint32_t* const* counts, std::size_t threads, std::size_t size,
                       const std::uint32_t* palette, std::uint32_t* pixels) {
    const Int di;
    const std::size_t n = hn::Lanes(di);
    const IntVector ground = hn::Set(di, static_cast<std::int32_t>(palette[0]));
    const auto* entries = reinterpret_cast<const std::int32_t*>(palette);
    std::size_t k = 0;
    for (; k + n <= size; k += n) {
        IntVector sum = hn::Zero(di);
        for (std::size_t thread = 0; thread < threads; ++thread)
            sum = hn::Add(sum, hn::LoadU(di, reinterpret_cast<const std::int32_t*>(counts[thread]) + k));
        IntVector pixel = ground;
        if (!hn::AllTrue(di, hn::Eq(sum, hn::Zero(di))))
            pixel = hn::GatherIndex(di, entries, toneIndices(sum));
        hn::StoreU(pixel, di, reinterpret_cast<std::int32_t*>(pixels) + k);
    }
    for (; k < size; ++k) {
        std::uint32_t sum = 0;
        for (std::size_t thread = 0; thread < threads; ++thread)
            sum += counts[thread][k];
        pixels[k] = palette[kernels::toneIndex(sum)];
    }
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace attractor {

HWY_EXPORT(addToCounts);
HWY_EXPORT(addInside);
HWY_EXPORT(addToPatch);
HWY_EXPORT(addToColours);
HWY_EXPORT(addToColoursInside);
HWY_EXPORT(iterate);
HWY_EXPORT(mapTones);

namespace {

struct SimdSet {
    std::string_view name;
    std::int64_t target;
};
constexpr SimdSet simdSets[] = {{"avx512", HWY_AVX3}, {"avx3", HWY_AVX3}, {"avx2", HWY_AVX2},
                                {"sse4", HWY_SSE4},   {"neon", HWY_NEON}, {"scalar", HWY_STATIC_TARGET}};

std::atomic<bool> isSelected = false;

} // namespace

void heedEnvironment() {
    [[maybe_unused]] static const bool done = [] {
        const char* name = std::getenv("BARYCAGE_SIMD");
        if (name != nullptr && !isSelected && !selectSimd(name))
            std::fprintf(stderr, "BARYCAGE_SIMD: this machine knows no “%s”\n", name);
        return true;
    }();
}

bool selectSimd(std::string_view name) {
    for (const SimdSet& set : simdSets) {
        if (set.name != name) continue;
        hwy::SetSupportedTargetsForTest(0); // restores detection
        if ((hwy::SupportedTargets() & set.target) == 0) return false;
        hwy::SetSupportedTargetsForTest(set.target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        isSelected = true;
        return true;
    }
    return false;
}

std::vector<std::string> simdNames() {
    const std::int64_t inUse = hwy::SupportedTargets();
    hwy::SetSupportedTargetsForTest(0); // restores detection
    std::vector<std::string> names;
    for (const SimdSet& set : simdSets)
        if ((hwy::SupportedTargets() & set.target) != 0) names.emplace_back(set.name);
    hwy::SetSupportedTargetsForTest(inUse);
    return names;
}

std::string simdName() {
    heedEnvironment();
    const std::int64_t target = hwy::SupportedTargets();
    for (const SimdSet& set : simdSets)
        if ((target & set.target) != 0) return std::string(set.name);
    return "scalar";
}

namespace kernels {

void addToCounts(const ShownWord& shown, const Run& run, const CellWindow& window, std::uint32_t* counts) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(addToCounts)(shown, run, window, counts);
}

void addInside(const ShownWord& shown, const Run& run, const CellWindow& window, std::uint32_t* counts) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(addInside)(shown, run, window, counts);
}

void addToPatch(const Word& word, const Run& run, const Patch& patch, const CellWindow& window,
                std::uint32_t* counts) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(addToPatch)(word, run, patch, window, counts);
}

std::uint32_t addToColours(const ShownWord& shown, const Run& run, const CellWindow& window,
                           const ColourCell& colour, ColourCell* cells) {
    heedEnvironment();
    return HWY_DYNAMIC_DISPATCH(addToColours)(shown, run, window, colour, cells);
}

std::uint32_t addToColoursInside(const ShownWord& shown, const Run& run, const CellWindow& window,
                                 const ColourCell& colour, ColourCell* cells) {
    heedEnvironment();
    return HWY_DYNAMIC_DISPATCH(addToColoursInside)(shown, run, window, colour, cells);
}

void iterate(Lanes& lanes, const ChaosTables& tables, Guard guard, std::size_t steps, float* x, float* y) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(iterate)(lanes, tables, guard, steps, x, y);
}

std::size_t toneIndex(std::uint64_t samples) {
    if (samples < exactCounts) return static_cast<std::size_t>(samples);
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(static_cast<float>(samples));
    return (bits >> 17) + exactCounts - ((127 + 7) << 6);
}

void mapTones(std::span<const std::uint32_t* const> counts, std::size_t size, const std::uint32_t* palette,
              std::uint32_t* pixels) {
    heedEnvironment();
    HWY_DYNAMIC_DISPATCH(mapTones)(counts.data(), counts.size(), size, palette, pixels);
}

} // namespace kernels
} // namespace attractor
#endif
