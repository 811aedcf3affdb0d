// SPDX-License-Identifier: MIT
#include "attractor/solid/thinned_covers.h"

#include "attractor/kernels/seen_points.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace attractor {

namespace {

// Range in which one cover does for all maps (1 + δ)·linear: bounds of δ, whose rows and columns are those of
// the screen.
constexpr float flat = 0.06F;
constexpr float deep = 0.04F;
ifs::Matrix<3> tolerances() {
    ifs::Matrix<3> result = ifs::Matrix<3>::Constant(static_cast<double>(deep));
    result.topLeftCorner<2, 2>().setConstant(static_cast<double>(flat));
    return result;
}

constexpr std::size_t minPoints = 4 * kernels::solidLanes;
constexpr std::size_t maxPoints = 1024;

// Points of a cover, in some order, that are seen in words of this linear map or one near it.
std::vector<std::size_t> seenPoints(const kernels::CoverPoints& points, std::size_t count,
                                    const ifs::Matrix<3>& linear) {
    constexpr kernels::PointTolerance tolerance{flat, deep, ThinnedCovers::pixelSlack,
                                                ThinnedCovers::depthSlack};
    std::array<std::vector<float>, 3> pixels;
    for (std::vector<float>& coordinates : pixels)
        coordinates.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const ifs::Vector<3> at = linear * ifs::Vector<3>(points.x[k], points.y[k], points.z[k]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            pixels[axis].push_back(static_cast<float>(at[static_cast<Eigen::Index>(axis)]));
    }
    std::vector<std::uint8_t> isSeen(count);
    kernels::markSeen({pixels[0].data(), pixels[1].data(), pixels[2].data(), count}, tolerance,
                      isSeen.data());
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < count; ++k)
        if (isSeen[k] != 0) result.push_back(k);
    return result;
}

// The size of words whose box this is, as kernels::drawSolid computes it.
double sizeOf(const ifs::Matrix<3>& linear, double depthScale) {
    const ifs::Vector<3> half = linear.cwiseAbs().rowwise().sum();
    return 2 * std::max({half.x(), half.y(), half.z() * depthScale});
}

// The coarsest that leaves no holes in words of that size; nullopt where rounding may make another one fit.
std::optional<const kernels::Cover*> coverFor(double size, std::span<const kernels::Cover> covers) {
    constexpr double margin = 1e-4;
    for (const kernels::Cover& cover : covers) {
        const double spacing = static_cast<double>(cover.spacing) * size / kernels::maxSpacing;
        if (std::abs(spacing - 1) <= margin) return std::nullopt;
        if (spacing < 1) return &cover;
    }
    return nullptr;
}

} // namespace

bool ThinnedCovers::Thinned::holdsFor(const ifs::Matrix<3>& other) const {
    static const ifs::Matrix<3> most = tolerances();
    const ifs::Matrix<3> difference = other - linear;
    if (!(difference.cwiseAbs().array() <= room.array()).all()) return false;
    return ((difference * inverse).cwiseAbs().array() <= most.array()).all();
}

bool ThinnedCovers::isExact(double ratio, int width, const DepthRange& range) {
    constexpr double maxRatio = 0.9; // largest ratio; words of other lengths must not look equally large
    constexpr int maxWidth = 8192;
    constexpr double codes = 16;
    return ratio <= maxRatio && width <= maxWidth &&
           codes * (range.far - range.near) <= depthSlack * maxDepthCode;
}

void ThinnedCovers::use(const Covers& covers, double ratio) {
    if (covers.isSame(m_covers) && ratio == m_ratio) return;
    m_covers = covers;
    m_ratio = ratio;
    m_thinned.clear();
    m_credit = m_tried = m_worthwhile = m_last = 0;
}

ThinnedCovers::Thinned* ThinnedCovers::known(const ifs::Matrix<3>& linear, const kernels::Cover& of) {
    const auto fits = [&](const Thinned& thinned) {
        return thinned.from == of.nearestFirst[0].x && thinned.holdsFor(linear);
    };
    if (m_last < m_thinned.size() && fits(m_thinned[m_last])) return &m_thinned[m_last];
    const auto found = std::ranges::find_if(m_thinned, fits);
    if (found == m_thinned.end()) return nullptr;
    // Moves frequently used covers towards the front.
    const auto earlier = m_thinned.begin() + (found - m_thinned.begin()) / 2;
    std::iter_swap(found, earlier);
    return &*earlier;
}

ThinnedCovers::Thinned* ThinnedCovers::thin(const ifs::Matrix<3>& linear, const kernels::Cover& of) {
    constexpr std::size_t most = 512;
    constexpr std::size_t workPerPoint = 600; // cost in points: three times as many as are drawn in that time
    constexpr std::size_t fewTried = 4;
    const std::size_t cost = workPerPoint * of.size;
    if (m_credit < cost || (m_tried >= fewTried && 2 * m_worthwhile < m_tried)) return nullptr;
    m_credit -= cost;
    ++m_tried;
    Thinned thinned;
    thinned.from = of.nearestFirst[0].x;
    thinned.linear = linear;
    thinned.inverse = linear.inverse();
    if (!thinned.inverse.allFinite()) return nullptr;
    thinned.room = tolerances() * linear.cwiseAbs();
    const unsigned octant =
        (linear(2, 0) < 0 ? 1U : 0U) | (linear(2, 1) < 0 ? 2U : 0U) | (linear(2, 2) < 0 ? 4U : 0U);
    const kernels::CoverPoints& from = of.nearestFirst[octant];
    std::vector<std::size_t> kept = seenPoints(from, of.size, linear);
    while (kept.size() % kernels::solidLanes != 0)
        kept.push_back(kept.front());
    if (4 * kept.size() <= 3 * of.size) {
        ++m_worthwhile;
        thinned.padded = kept.size();
        for (const float* array : {from.x, from.y, from.z})
            for (const std::size_t k : kept)
                thinned.coordinates.push_back(array[k]);
    }
    if (m_thinned.size() < most) return &m_thinned.emplace_back(std::move(thinned));
    const auto oldest = std::ranges::min_element(m_thinned, {}, &Thinned::used);
    *oldest = std::move(thinned);
    return &*oldest;
}

const kernels::Cover* ThinnedCovers::find(const ifs::Matrix<3>& linear, double depthScale,
                                          std::span<const kernels::Cover> covers) {
    ifs::Matrix<3> word = linear;
    double size = sizeOf(word, depthScale);
    if (!linear.allFinite() || !std::isfinite(size)) return nullptr;
    std::optional<const kernels::Cover*> cover = coverFor(size, covers);
    while (cover == nullptr) {
        size *= m_ratio;
        word *= m_ratio;
        cover = coverFor(size, covers);
    }
    if (!cover || (*cover)->size < minPoints || (*cover)->size > maxPoints) return nullptr;
    Thinned* thinned = known(word, **cover);
    if (thinned == nullptr) thinned = thin(word, **cover);
    if (thinned == nullptr) return nullptr;
    m_last = static_cast<std::size_t>(thinned - m_thinned.data());
    thinned->used = ++m_clock;
    if (thinned->padded == 0) return nullptr;
    m_found.spacing = (*cover)->spacing;
    m_found.onlyFor = static_cast<float>(size);
    m_found.size = thinned->padded;
    m_found.work = (*cover)->size;
    const float* x = thinned->coordinates.data();
    m_found.nearestFirst.fill({x, x + thinned->padded, x + 2 * thinned->padded});
    return &m_found;
}

} // namespace attractor
