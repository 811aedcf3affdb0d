// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_projection.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ifs {

namespace {

constexpr double projectionDetail = 0.5; // pixels; finest detail of a singular map's image

using Interval = std::pair<double, double>;

std::vector<Interval> joined(std::vector<Interval> intervals, double gap) {
    std::sort(intervals.begin(), intervals.end());
    std::vector<Interval> result;
    for (const Interval& interval : intervals) {
        if (result.empty() || interval.first > result.back().second + gap)
            result.push_back(interval);
        else
            result.back().second = std::max(result.back().second, interval.second);
    }
    return result;
}

// Projection of the attractor of `maps`, inside `hull`, on `axis`: intervals that hold all of it and no point
// further than `detail` from it, in order and apart. nullopt when they would be too many.
std::optional<std::vector<Interval>> projection(const std::vector<AffineMap<2>>& maps, const Polygon& hull,
                                                const Vector<2>& axis, double detail) {
    constexpr std::size_t maxIntervals = 300'000;
    struct Seen {
        Eigen::RowVector2d row;
        double offset;
    };
    std::vector<Seen> open{{axis.transpose(), 0}};
    std::vector<Interval> found;
    while (!open.empty()) {
        if (open.size() + found.size() > maxIntervals) return std::nullopt;
        const Seen copy = open.back();
        open.pop_back();
        Interval interval{HUGE_VAL, -HUGE_VAL};
        for (const auto& point : hull) {
            const double position = copy.row.dot(point) + copy.offset;
            interval = {std::min(interval.first, position), std::max(interval.second, position)};
        }
        if (interval.second - interval.first <= detail) {
            found.push_back(interval);
            continue;
        }
        for (const auto& map : maps)
            open.push_back({copy.row * map.linear, copy.offset + copy.row.dot(map.translation)});
    }
    return joined(std::move(found), detail);
}

} // namespace

// Thickened, bars across the direction that a map keeps become bars of the same thickness.
CopyProjection projectionAlong(const std::vector<AffineMap<2>>& maps, const CopyFrame& frame,
                               const Vector<2>& along, double length) {
    const Vector<2> across = Vector<2>(-along.y(), along.x()) * (std::max(frame.diameter, frame.pixel) / 2);
    double detail = std::max(projectionDetail * frame.pixel / length, 2 * frame.hullError);
    auto intervals = projection(maps, frame.hull, along, detail);
    while (!intervals)
        intervals = projection(maps, frame.hull, along, detail *= 2);
    CopyProjection result{{}, detail};
    for (const auto& [low, high] : *intervals) {
        const Vector<2> middle = frame.centre - along.dot(frame.centre) * along;
        const Vector<2> from = middle + (low - detail / 2) * along;
        const Vector<2> to = middle + (high + detail / 2) * along;
        result.bars.push_back({from - across, to - across, to + across, from + across});
    }
    return result;
}

CopyProjection projectionBy(const std::vector<AffineMap<2>>& maps, const CopyFrame& frame,
                            const AffineMap<2>& map) {
    const double length = std::max(spectralNorm<2>(map.linear), frame.thinness); // length as drawn
    return projectionAlong(maps, frame, longestDirection(map.linear), length);
}

Vector<2> longestDirection(const Matrix<2>& linear) {
    const Matrix<2> square = linear.transpose() * linear;
    const double angle = std::atan2(2 * square(0, 1), square(0, 0) - square(1, 1)) / 2;
    return {std::cos(angle), std::sin(angle)};
}

// Along the line that the map keeps by what the projection leaves open, across it by half a bar and half the
// attractor's thickness.
double maxShift(const CopyFrame& frame, const CopyProjection& projection, const AffineMap<2>& drawn,
                const AffineMap<2>& map) {
    const Vector<2> side = projection.bars.front()[3] - projection.bars.front()[0];
    const Vector<2> across = side.normalized();
    const Vector<2> along(across.y(), -across.x());
    return ((drawn.linear - map.linear) * along).norm() * frame.diameter +
           2 * (drawn.linear * along).norm() * projection.detail + (drawn.linear * side).norm() / 2 +
           (map.linear * across).norm() * frame.diameter;
}

// The bars hold all that the line keeps of the attractor.
double maxMissing(const CopyFrame& frame, const CopyProjection& projection, const AffineMap<2>& drawn,
                  const AffineMap<2>& map) {
    const Vector<2> across = (projection.bars.front()[3] - projection.bars.front()[0]).normalized();
    const Vector<2> along(across.y(), -across.x());
    const Vector<2> middle = drawn(frame.centre) - map(frame.centre);
    return middle.norm() + ((drawn.linear - map.linear) * along).norm() * frame.diameter +
           (map.linear * across).norm() * frame.diameter;
}

} // namespace ifs
