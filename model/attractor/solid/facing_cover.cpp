// SPDX-License-Identifier: MIT
#include "attractor/solid/facing_cover.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace attractor {

namespace {

using ifs::Vector;

// The one by which all maps shrink; nullopt where they do anything else.
std::optional<double> commonRatio(const PreparedSpace& system) {
    constexpr double rounding = 1e-12;
    const double ratio = system.maps.front().linear(0, 0);
    if (!(ratio > 0 && ratio < 1)) return std::nullopt;
    for (const ifs::AffineMap<3>& map : system.maps)
        if (!((map.linear - ratio * ifs::Matrix<3>::Identity()).cwiseAbs().maxCoeff() <= rounding))
            return std::nullopt;
    return ratio;
}

// Which of the points, in pixels, are the nearest ones of some pixel for some place of the grid of pixels.
std::vector<bool> nearestSomewhere(const std::vector<Vector<3>>& points) {
    constexpr int steps = 8; // of a pixel, along each side
    Vector<3> low = points.front();
    Vector<3> high = points.front();
    for (const Vector<3>& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    const auto width = static_cast<std::size_t>(high.x() - low.x()) + 2;
    const auto height = static_cast<std::size_t>(high.y() - low.y()) + 2;
    constexpr auto none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> nearest(width * height);
    std::vector<bool> result(points.size());
    for (int step = 0; step < steps * steps; ++step) {
        const double x = low.x() - static_cast<double>(step % steps) / steps;
        const double y = low.y() - static_cast<double>(step / steps) / steps;
        std::fill(nearest.begin(), nearest.end(), none);
        for (std::size_t k = 0; k < points.size(); ++k) {
            std::size_t& best = nearest[static_cast<std::size_t>(points[k].y() - y) * width +
                                        static_cast<std::size_t>(points[k].x() - x)];
            if (best == none || points[k].z() < points[best].z()) best = k;
        }
        for (const std::size_t k : nearest)
            if (k != none) result[k] = true;
    }
    return result;
}

} // namespace

FacingCover::FacingCover(const PreparedSpace& system, const SpaceView& view,
                         std::span<const kernels::Cover> covers) {
    constexpr std::size_t worthwhile = 4 * kernels::solidLanes;
    constexpr double maxSize = 32; // pixels; of what is larger, too much is drawn that is hidden
    if (system.maps.empty() || !system.contracts || view.isPerspective()) return;
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
    const std::vector<bool> nearest = nearestSomewhere(points);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (nearest[k]) order.push_back(k);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return points[a].z() < points[b].z(); });
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
    result.size = m_padded;
    const float* x = m_coordinates.data();
    result.nearestFirst.fill({x, x + m_padded, x + 2 * m_padded});
    return result;
}

} // namespace attractor
