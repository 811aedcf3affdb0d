// SPDX-License-Identifier: MIT
#include "attractor/shutter/motion_steps.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/folds/prepared_request.h"
#include "attractor/samples/prepared_space.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

constexpr int tracked = 4096;
constexpr int forgotten = 64; // steps before the first point

// Points of orbits that choose every map equally often, whatever its weight, so that a chosen address stays.
template <int Dim, class Show>
void track(const std::vector<ifs::AffineMap<Dim>>& maps, const std::vector<ifs::MovedBranch<Dim>>& moved,
           const ifs::Vector<Dim>& start, Show show) {
    const auto pieces = ifs::pieces<Dim>(moved, maps.size());
    std::size_t longest = 0;
    for (const auto& piece : pieces)
        longest = std::max(longest, piece.word.size());
    ifs::Word address(longest, 0);
    ifs::Vector<Dim> x = start;
    for (int n = 0; n < forgotten + tracked; ++n) {
        const auto map = static_cast<std::size_t>(mixed(static_cast<std::uint64_t>(n)) % maps.size());
        x = maps[map](x);
        if (!x.allFinite()) x = start;
        if (longest > 0) {
            std::shift_right(address.begin(), address.end(), 1);
            address.front() = static_cast<int>(map);
        }
        if (n >= forgotten) show(longest > 0 ? ifs::pieceOf<Dim>(pieces, address).change(x) : x);
    }
}

bool isIn(const RasterSize& size, const ifs::Vector<2>& pixel) {
    return pixel.x() >= 0 && pixel.x() <= size.width && pixel.y() >= 0 && pixel.y() <= size.height;
}

// The longest way of a point that is in the picture, or else of any point; infinite where one has no place.
double longestWay(const TrackedPoints& from, const TrackedPoints& to) {
    double seen = -1, all = 0;
    for (std::size_t i = 0; i < from.pixels.size(); ++i) {
        const double way = (to.pixels[i] - from.pixels[i]).norm();
        const bool isSeen = isIn(from.size, from.pixels[i]) || isIn(to.size, to.pixels[i]);
        all = std::max(all, std::isfinite(way) ? way : HUGE_VAL);
        if (isSeen) seen = std::max(seen, way);
    }
    return seen >= 0 ? seen : all;
}

} // namespace

TrackedPoints trackedPoints(const RenderRequest& request) {
    PreparedRequest prepared;
    prepared.set(request);
    TrackedPoints points{{}, {request.camera.width, request.camera.height}};
    if (!prepared.isDrawable()) return points;
    const Projection& projection = prepared.projection();
    const PreparedSystem& system = prepared.system();
    const double perPixel = prepared.cellsPerPixel();
    track<2>(system.maps, system.moved, system.centre, [&](const ifs::Vector<2>& x) {
        points.pixels.push_back(projection.cell(projection.cage(x)) / perPixel);
    });
    return points;
}

TrackedPoints trackedPoints(const SpaceRequest& request) {
    TrackedPoints points{{}, request.camera.size};
    const PreparedSpace system = preparedSpace(request.system, request.moved);
    if (system.maps.empty() || !isUsable(request.camera)) return points;
    const bool isPlaced = request.cage && ifs::isValid(*request.cage);
    const ifs::AffineMap<3> cage = isPlaced ? ifs::displayMap(*request.cage) : ifs::AffineMap<3>();
    track<3>(system.maps, system.moved, system.centre, [&](const ifs::Vector<3>& x) {
        points.pixels.push_back(toScreen(request.camera, cage(x)).pixel);
    });
    return points;
}

int stepsFor(const std::vector<TrackedPoints>& moments) {
    double longest = 0;
    for (std::size_t m = 1; m < moments.size(); ++m) {
        if (moments[m].pixels.size() != moments[m - 1].pixels.size()) return maxSteps;
        longest = std::max(longest, longestWay(moments[m - 1], moments[m]));
    }
    const double steps = std::ceil(longest * static_cast<double>(moments.size() - 1));
    return steps < maxSteps ? std::max(1, static_cast<int>(steps)) : maxSteps;
}

} // namespace attractor
