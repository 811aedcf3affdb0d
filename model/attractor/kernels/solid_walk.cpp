// SPDX-License-Identifier: MIT
#include "attractor/kernels/solid_walk.h"

#include "attractor/kernels/kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "attractor/kernels/solid_walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "attractor/kernels/vectors-inl.h" // for each target: behind foreach_target.h

HWY_BEFORE_NAMESPACE();
namespace attractor::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using kernels::Cover;
using kernels::KeyBand;
using kernels::OpenWord;
using kernels::SolidJob;
using kernels::SolidMaps;
using kernels::SolidWord;

using Unsigned = hn::RebindToUnsigned<Float>;
static_assert(hn::MaxLanes(Float()) <= kernels::solidLanes);

// Rounding may have moved a point that far out of the box around its word.
constexpr float pixelSlack = 1.0F / 64;
constexpr float codeSlack = 16;
constexpr int smallBox = 32; // pixels wide
constexpr std::size_t maxOpen = 1U << 18;
constexpr std::size_t workPerCheck = 1U << 14; // between two checks of the stop token
constexpr auto maxCode = static_cast<float>(maxDepthCode);
constexpr std::size_t chunk = 64; // points compared before any of them is stored

// The pixels touched by a box, and its nearest key.
struct Touched {
    int firstColumn, lastColumn, firstRow, lastRow;
    std::uint32_t nearest; // key of the nearest point
    bool any;
};

HWY_ATTR static HWY_INLINE Touched touched(const OpenWord& open, const KeyBand& band) {
    const auto& [x, y, z] = open.word.middle;
    const float left = x - open.half[0] - pixelSlack;
    const float right = x + open.half[0] + pixelSlack;
    const float top = y - open.half[1] - pixelSlack;
    const float bottom = y + open.half[1] + pixelSlack;
    const auto width = static_cast<float>(band.width());
    const auto rows = static_cast<float>(band.rows());
    Touched result{};
    result.any = right >= 0 && left < width && bottom >= 0 && top < rows;
    if (!result.any) return result;
    result.firstColumn = left > 0 ? static_cast<int>(left) : 0;
    result.lastColumn = right < width ? static_cast<int>(right) : band.width() - 1;
    result.firstRow = top > 0 ? static_cast<int>(top) : 0;
    result.lastRow = bottom < rows ? static_cast<int>(bottom) : band.rows() - 1;
    const float near = z - open.half[2] - codeSlack;
    result.nearest = near > 0 ? static_cast<std::uint32_t>(std::min(near, maxCode)) << 8 : 0;
    return result;
}

HWY_ATTR static HWY_INLINE std::uint32_t farthestOf(KeyBand& band, int tileRow, int tileColumn) {
    using Eight = hn::CappedTag<std::uint32_t, KeyBand::tile>;
    const Eight d;
    const int number = tileRow * band.tilesAcross() + tileColumn;
    std::uint8_t& stale = band.stale()[number];
    std::uint32_t& farthest = band.farthest()[number];
    if (stale == 0) return farthest;
    stale = 0;
    const std::uint32_t* keys =
        band.keys() + (tileRow * KeyBand::tile) * band.stride() + tileColumn * KeyBand::tile;
    auto most = hn::Zero(d);
    for (int row = 0; row < KeyBand::tile; ++row, keys += band.stride())
        for (std::size_t k = 0; k < KeyBand::tile; k += hn::Lanes(d))
            most = hn::Max(most, hn::LoadU(d, keys + k));
    alignas(32) std::uint32_t parts[KeyBand::tile];
    hn::Store(most, d, parts);
    farthest = parts[0];
    for (std::size_t k = 1; k < hn::Lanes(d); ++k)
        farthest = std::max(farthest, parts[k]);
    return farthest;
}

// Returns true if all keys in the touched tiles are nearer. At the very end of the range depths cannot be
// told apart: there the first key stays.
HWY_ATTR static HWY_INLINE bool isHidden(const Touched& t, KeyBand& band) {
    const std::uint32_t limit = t.nearest == maxDepthCode << 8 ? emptyKey : t.nearest;
    for (int row = t.firstRow / KeyBand::tile; row <= t.lastRow / KeyBand::tile; ++row)
        for (int column = t.firstColumn / KeyBand::tile; column <= t.lastColumn / KeyBand::tile; ++column)
            if (farthestOf(band, row, column) >= limit) return false;
    return true;
}

// The same pixel by pixel, for a box that is not large.
HWY_ATTR static HWY_INLINE bool isBehindPixels(const Touched& t, KeyBand& band) {
    const Unsigned du;
    const std::uint32_t limit = t.nearest == maxDepthCode << 8 ? emptyKey : t.nearest;
    const auto limits = hn::Set(du, limit);
    const int lanes = static_cast<int>(hn::Lanes(du));
    const auto numbers = hn::Iota(du, 0);
    const std::uint32_t* keys = band.keys() + t.firstRow * band.stride();
    for (int row = t.firstRow; row <= t.lastRow; ++row, keys += band.stride())
        for (int column = t.firstColumn; column <= t.lastColumn; column += lanes) {
            const auto counts = hn::Set(du, static_cast<std::uint32_t>(t.lastColumn - column + 1));
            const auto nearer = hn::Lt(hn::LoadU(du, keys + column), limits);
            if (!hn::AllFalse(du, hn::AndNot(nearer, hn::Lt(numbers, counts)))) return false;
        }
    return true;
}

struct Row {
    FloatVector a, b, c, constant;

    HWY_ATTR Row(const SolidWord& word, int row)
        : a(hn::Set(Float(), word.linear[static_cast<std::size_t>(3 * row)])),
          b(hn::Set(Float(), word.linear[static_cast<std::size_t>(3 * row + 1)])),
          c(hn::Set(Float(), word.linear[static_cast<std::size_t>(3 * row + 2)])),
          constant(hn::Set(Float(), word.middle[static_cast<std::size_t>(row)])) {}
    HWY_ATTR HWY_INLINE FloatVector linear(FloatVector x, FloatVector y, FloatVector z) const {
        return hn::Add(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), hn::Mul(c, z)); // never fused
    }
    HWY_ATTR HWY_INLINE FloatVector operator()(FloatVector x, FloatVector y, FloatVector z) const {
        return hn::Add(linear(x, y, z), constant);
    }
};

// Index into Cover::nearestFirst: bit k is set if depth falls along axis k of the box.
HWY_ATTR static HWY_INLINE std::size_t octant(const SolidWord& word) {
    return (word.linear[6] < 0 ? 1U : 0U) | (word.linear[7] < 0 ? 2U : 0U) | (word.linear[8] < 0 ? 4U : 0U);
}

// Gather, compare, store the few that are nearer. Returns whether there were any.
template <bool inside>
HWY_ATTR static HWY_INLINE bool splatAt(const SolidWord& word, const Cover& cover, KeyBand& band) {
    const Float d;
    const Int di;
    const Unsigned du;
    const Row columns(word, 0);
    const Row rows(word, 1);
    const Row depths(word, 2);
    const IntVector stride = hn::Set(di, band.stride());
    const auto colour = hn::Set(du, static_cast<std::uint32_t>(std::max(word.colour, 0)));
    const FloatVector zero = hn::Zero(d);
    const FloatVector farthest = hn::Set(d, maxCode);
    [[maybe_unused]] const FloatVector width = hn::Set(d, static_cast<float>(band.width()));
    [[maybe_unused]] const FloatVector height = hn::Set(d, static_cast<float>(band.rows()));
    [[maybe_unused]] const IntVector outside = hn::Set(di, static_cast<std::int32_t>(band.overflow()));
    std::uint32_t* HWY_RESTRICT keys = band.keys();
    const kernels::CoverPoints& points = cover.nearestFirst[octant(word)];
    alignas(64) std::uint32_t newKeys[chunk];
    alignas(64) std::int32_t cells[chunk];
    bool any = false;
    for (std::size_t first = 0; first < cover.size; first += chunk) {
        const std::size_t count = std::min(chunk, cover.size - first);
        std::uint64_t nearer = 0;
        for (std::size_t at = 0; at < count; at += hn::Lanes(d)) {
            const FloatVector x = hn::LoadU(d, points.x + first + at);
            const FloatVector y = hn::LoadU(d, points.y + first + at);
            const FloatVector z = hn::LoadU(d, points.z + first + at);
            const FloatVector column = columns(x, y, z);
            const FloatVector row = rows(x, y, z);
            IntVector cell;
            if constexpr (inside) {
                cell = hn::Add(hn::Mul(truncated(row), stride), truncated(column));
            } else {
                const auto in = hn::And(hn::And(hn::Ge(column, zero), hn::Lt(column, width)),
                                        hn::And(hn::Ge(row, zero), hn::Lt(row, height)));
                cell = hn::Add(hn::Mul(truncated(hn::IfThenElseZero(in, row)), stride),
                               truncated(hn::IfThenElseZero(in, column)));
                cell = hn::IfThenElse(hn::RebindMask(di, in), cell, outside);
            }
            const FloatVector depth = hn::Min(hn::Max(depths(x, y, z), zero), farthest);
            const auto key = hn::Or(hn::ShiftLeft<8>(hn::BitCast(du, truncated(depth))), colour);
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(du, hn::Lt(key, hn::GatherIndex(du, keys, cell)), bits);
            hn::Store(key, du, newKeys + at);
            hn::Store(cell, di, cells + at);
            nearer |= static_cast<std::uint64_t>(bits[0] | bits[1] << 8) << at;
        }
        any = any || nearer != 0;
        for (; nearer != 0; nearer &= nearer - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(nearer));
            const std::uint32_t old = keys[cells[k]]; // several points may fall into one cell
            const std::uint32_t nearest = newKeys[k];
            keys[cells[k]] = nearest < old ? nearest : old;
        }
    }
    return any;
}

HWY_ATTR static void splat(const OpenWord& open, const Touched& t, const Cover& cover, SolidJob& job) {
    KeyBand& band = *job.band;
    const auto& [x, y, z] = open.word.middle;
    const bool inside = x - open.half[0] >= 1 && x + open.half[0] <= static_cast<float>(band.width() - 1) &&
                        y - open.half[1] >= 1 && y + open.half[1] <= static_cast<float>(band.rows() - 1);
    const bool any = inside ? splatAt<true>(open.word, cover, band) : splatAt<false>(open.word, cover, band);
    job.points += cover.size;
    if (!any) return;
    for (int row = t.firstRow / KeyBand::tile; row <= t.lastRow / KeyBand::tile; ++row) {
        std::uint8_t* stale = band.stale() + row * band.tilesAcross();
        for (int column = t.firstColumn / KeyBand::tile; column <= t.lastColumn / KeyBand::tile; ++column)
            stale[column] = 1;
    }
}

// The words of the next level, as arrays: 9 linear coefficients, 3 middles, 3 half extents.
constexpr std::size_t childArrays = 15;

HWY_ATTR static void placeChildren(const SolidWord& word, const SolidMaps& maps, std::size_t padded,
                                   float* HWY_RESTRICT out) {
    const Float d;
    for (int row = 0; row < 3; ++row) {
        const Row outer(word, row);
        const auto r = static_cast<std::size_t>(row);
        for (std::size_t k = 0; k < maps.count; k += hn::Lanes(d)) {
            FloatVector half = hn::Zero(d);
            for (std::size_t column = 0; column < 3; ++column) {
                const FloatVector value = outer.linear(hn::LoadU(d, maps.linear[column] + k),
                                                       hn::LoadU(d, maps.linear[column + 3] + k),
                                                       hn::LoadU(d, maps.linear[column + 6] + k));
                hn::StoreU(value, d, out + (3 * r + column) * padded + k);
                half = hn::Add(half, hn::Abs(value));
            }
            const FloatVector middle = outer(hn::LoadU(d, maps.shift[0] + k), hn::LoadU(d, maps.shift[1] + k),
                                             hn::LoadU(d, maps.shift[2] + k));
            hn::StoreU(middle, d, out + (9 + r) * padded + k);
            hn::StoreU(half, d, out + (12 + r) * padded + k);
        }
    }
}

// Bits that are in the order of the numbers.
HWY_ATTR static HWY_INLINE std::uint32_t ordered(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

HWY_ATTR static void sortFew(std::uint64_t* values, std::size_t count) {
    for (std::size_t k = 1; k < count; ++k) {
        const std::uint64_t value = values[k];
        std::size_t at = k;
        for (; at > 0 && values[at - 1] > value; --at)
            values[at] = values[at - 1];
        values[at] = value;
    }
}

// Opens the children that meet the band, the nearest one on top.
HWY_ATTR static void expand(const SolidWord& word, SolidJob& job) {
    constexpr std::size_t few = 32;
    const SolidMaps& maps = job.maps;
    const std::size_t padded =
        (maps.count + kernels::solidLanes - 1) / kernels::solidLanes * kernels::solidLanes;
    if (job.children.size() < childArrays * padded) job.children.resize(childArrays * padded);
    if (job.order.size() < maps.count) job.order.resize(maps.count);
    const float* HWY_RESTRICT child = job.children.data();
    std::uint64_t* order = job.order.data();
    placeChildren(word, maps, padded, job.children.data());
    const auto width = static_cast<float>(job.band->width());
    const auto rows = static_cast<float>(job.band->rows());
    std::size_t count = 0;
    for (std::size_t i = 0; i < maps.count; ++i) {
        const float x = child[9 * padded + i];
        const float y = child[10 * padded + i];
        const float halfX = child[12 * padded + i] + pixelSlack;
        const float halfY = child[13 * padded + i] + pixelSlack;
        if (!(x + halfX >= 0 && x - halfX < width && y + halfY >= 0 && y - halfY < rows)) continue;
        const float near = child[11 * padded + i] - child[14 * padded + i];
        // Farthest first; among equals, the last first.
        order[count++] = static_cast<std::uint64_t>(~ordered(near)) << 32 | (0xFFFFFFFFU - i);
    }
    if (count <= few)
        sortFew(order, count);
    else
        std::sort(order, order + count);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = 0xFFFFFFFFU - (order[k] & 0xFFFFFFFFU);
        OpenWord& open = job.open.emplace_back();
        for (std::size_t j = 0; j < 9; ++j)
            open.word.linear[j] = child[j * padded + i];
        for (std::size_t j = 0; j < 3; ++j) {
            open.word.middle[j] = child[(9 + j) * padded + i];
            open.half[j] = child[(12 + j) * padded + i];
        }
        open.word.colour = word.colour == SolidWord::uncoloured ? maps.colours[i] : word.colour;
    }
}

// The coarsest cover whose points leave no holes; nullptr where none is fine enough.
HWY_ATTR static HWY_INLINE const Cover* coverFor(const OpenWord& open, const SolidJob& job) {
    constexpr float sameSize = 1e-3F;
    const float size = 2 * std::max({open.half[0], open.half[1], open.half[2] * job.pixelsPerCode});
    for (const Cover& cover : job.covers)
        if (cover.spacing * size <= kernels::maxSpacing &&
            (cover.onlyFor == 0 || std::abs(size - cover.onlyFor) <= sameSize * size))
            return &cover;
    return nullptr;
}

HWY_ATTR static OpenWord opened(const SolidWord& word) {
    OpenWord open{word, {}};
    for (std::size_t row = 0; row < 3; ++row)
        open.half[row] = std::abs(word.linear[3 * row]) + std::abs(word.linear[3 * row + 1]) +
                         std::abs(word.linear[3 * row + 2]);
    return open;
}

HWY_ATTR bool isHiddenWord(const SolidWord& word, float around, KeyBand& band) {
    OpenWord open = opened(word);
    open.half[0] += around;
    open.half[1] += around;
    const Touched t = touched(open, band);
    return !t.any || isHidden(t, band);
}

HWY_ATTR bool drawSolid(const SolidWord& word, SolidJob& job, const std::stop_token& stop) {
    job.open.assign(1, opened(word));
    std::size_t work = 0;
    while (!job.open.empty()) {
        const OpenWord open = job.open.back();
        job.open.pop_back();
        if (work >= workPerCheck) {
            if (stop.stop_requested()) return false;
            job.budget -= std::min(job.budget, work);
            work = 0;
        }
        ++work;
        ++job.words;
        const Touched t = touched(open, *job.band);
        if (!t.any || isHidden(t, *job.band)) continue;
        if (t.lastColumn - t.firstColumn < smallBox && isBehindPixels(t, *job.band)) continue;
        const bool spent = job.budget <= work || job.open.size() + job.maps.count > maxOpen;
        const Cover* cover = coverFor(open, job);
        if (cover == nullptr && spent) {
            cover = &job.covers.back();
            ++job.coarse;
        }
        if (cover != nullptr && (open.word.colour != SolidWord::uncoloured || spent)) {
            splat(open, t, *cover, job);
            work += cover->work / kernels::solidLanes;
        } else {
            expand(open.word, job);
            work += job.maps.count;
        }
    }
    job.budget -= std::min(job.budget, work);
    return true;
}

} // namespace attractor::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace attractor {

HWY_EXPORT(drawSolid);
HWY_EXPORT(isHiddenWord);

namespace kernels {

void KeyBand::reset(int width, int rows) {
    const auto padded = [](int size, int multiple) { return (size + multiple - 1) / multiple * multiple; };
    m_width = width;
    m_rows = rows;
    m_stride = padded(width, static_cast<int>(solidLanes));
    m_paddedRows = padded(rows, tile);
    m_keys.assign(overflow() + solidLanes, 0); // padding counts as nearest
    for (int y = 0; y < rows; ++y) {
        std::uint32_t* first =
            m_keys.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(m_stride);
        std::fill_n(first, width, emptyKey);
    }
    const auto tiles =
        static_cast<std::size_t>(tilesAcross()) * static_cast<std::size_t>(m_paddedRows / tile);
    m_farthest.assign(tiles, emptyKey);
    m_stale.assign(tiles, 0);
}

bool isHidden(const SolidWord& word, float around, KeyBand& band) {
    heedEnvironment();
    return HWY_DYNAMIC_DISPATCH(isHiddenWord)(word, around, band);
}

bool drawSolid(const SolidWord& word, SolidJob& job, const std::stop_token& stop) {
    heedEnvironment();
    return HWY_DYNAMIC_DISPATCH(drawSolid)(word, job, stop);
}

} // namespace kernels
} // namespace attractor
#endif
