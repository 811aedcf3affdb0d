// SPDX-License-Identifier: MIT
#include "attractor/solid/facing_cover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

namespace attractor {

using ifs::Vector;

std::optional<double> commonRatio(const PreparedSpace& system) {
    if (system.maps.empty()) return std::nullopt;
    constexpr double rounding = 1e-12;
    const double ratio = system.maps.front().linear(0, 0);
    if (!(ratio > 0 && ratio < 1)) return std::nullopt;
    for (const ifs::AffineMap<3>& map : system.maps)
        if (!((map.linear - ratio * ifs::Matrix<3>::Identity()).cwiseAbs().maxCoeff() <= rounding))
            return std::nullopt;
    return ratio;
}

namespace {

constexpr std::size_t steps = 8; // parts of a pixel along each axis

// The pixels that a point falls into, along one axis, as the grid of pixels moves: `pixel` up to some step,
// the next one from then on.
struct Moving {
    std::size_t pixel = 0;
    std::size_t change = steps; // first step at which the point falls into the next pixel
};

Moving moving(double at, double low) {
    const auto pixelAt = [&](std::size_t step) {
        return static_cast<std::size_t>(at - (low - static_cast<double>(step) / steps));
    };
    Moving result{pixelAt(0), 1};
    while (result.change < steps && pixelAt(result.change) == result.pixel)
        ++result.change;
    return result;
}

// Bit 8·y + x of a pixel stands for a place of the grid x and y steps from the first.
using Places = std::uint64_t;
constexpr Places firstColumn = 0x0101010101010101;
constexpr Places firstSteps(std::size_t count) {
    return count >= steps * steps ? ~Places{0} : (Places{1} << count) - 1;
}

// Marks the points, in pixels and from the nearest to the farthest, that are the nearest of some pixel for
// some place of the grid of pixels.
std::vector<bool> nearestSomewhere(const std::vector<Vector<3>>& points) {
    Vector<3> low = points.front();
    Vector<3> high = points.front();
    for (const Vector<3>& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    const auto width = static_cast<std::size_t>(high.x() - low.x()) + 3;
    const auto height = static_cast<std::size_t>(high.y() - low.y()) + 3;
    std::vector<Places> taken(width * height);
    std::vector<bool> result(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Moving x = moving(points[k].x(), low.x());
        const Moving y = moving(points[k].y(), low.y());
        const Places left = firstColumn * firstSteps(x.change), above = firstSteps(steps * y.change);
        Places* const pixel = &taken[y.pixel * width + x.pixel];
        const auto takes = [](Places& there, Places places) {
            const bool isNew = (places & ~there) != 0;
            there |= places;
            return isNew;
        };
        result[k] = takes(pixel[0], left & above) | takes(pixel[1], ~left & above) |
                    takes(pixel[width], left & ~above) | takes(pixel[width + 1], ~left & ~above);
    }
    return result;
}

} // namespace

FacingCover::FacingCover(const PreparedSpace& system, const SpaceView& view,
                         std::span<const kernels::Cover> covers) {
    constexpr std::size_t worthwhile = 4 * kernels::solidLanes;
    constexpr double maxSize = 32; // pixels; larger covers draw too many hidden points
    if (!system.contracts || view.isPerspective()) return;
    const std::optional<double> ratio = commonRatio(system);
    SeenWord word = seen(view.toPixels * system.fromBox(), view);
    if (!ratio || !std::isfinite(word.size())) return;
    double size = word.size();
    ifs::Matrix<3> linear = word.onScreen.linear;
    const kernels::Cover* cover = nullptr;
    while (size > maxSize) {
        size *= *ratio;
        linear *= *ratio;
    }
    while (size > kernels::maxSpacing && cover == nullptr) {
        const auto fits = [&](const kernels::Cover& c) {
            return c.spacing * static_cast<float>(size) <= kernels::maxSpacing;
        };
        const auto found = std::find_if(covers.begin(), covers.end(), fits);
        if (found != covers.end()) {
            cover = &*found;
            break;
        }
        size *= *ratio;
        linear *= *ratio;
    }
    if (cover == nullptr || cover->size < worthwhile) return;
    const kernels::CoverPoints& from = cover->nearestFirst[0];
    std::vector<Vector<3>> points;
    for (std::size_t k = 0; k < cover->size; ++k)
        points.emplace_back(linear * Vector<3>(from.x[k], from.y[k], from.z[k]));
    std::vector<std::size_t> all(points.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::stable_sort(all.begin(), all.end(),
                     [&](std::size_t a, std::size_t b) { return points[a].z() < points[b].z(); });
    std::vector<Vector<3>> nearestFirst;
    for (const std::size_t k : all)
        nearestFirst.push_back(points[k]);
    const std::vector<bool> nearest = nearestSomewhere(nearestFirst);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (nearest[k]) order.push_back(all[k]);
    m_spacing = cover->spacing;
    m_size = static_cast<float>(size);
    while (order.size() % kernels::solidLanes != 0)
        order.push_back(order.front());
    m_padded = order.size();
    for (const float* array : {from.x, from.y, from.z})
        for (const std::size_t k : order)
            m_coordinates.push_back(array[k]);
}

kernels::Cover FacingCover::cover() const {
    kernels::Cover result;
    result.spacing = m_spacing;
    result.onlyFor = m_size;
    result.size = result.work = m_padded;
    const float* x = m_coordinates.data();
    result.nearestFirst.fill({x, x + m_padded, x + 2 * m_padded});
    return result;
}

} // namespace attractor
