// SPDX-License-Identifier: MIT
#include "document/edits/maps/maps_arrange.h"

#include "document/edits/maps/map_locks.h"
#include "document/fractal/fractal_geometry.h"
#include "document/maps/map_handles.h"
#include "document/text/text.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>
#include <vector>

namespace document {

namespace {

using ifs::AffineMap;
using ifs::Vector;

Vector<2> mean(const std::vector<Vector<2>>& points) {
    Vector<2> sum = Vector<2>::Zero();
    for (const Vector<2>& point : points)
        sum += point / double(points.size());
    return sum;
}

MapHandles handlesOf(const Fractal& fractal, const ifs::ControlCage<2>& cage) {
    return {std::make_shared<const Fractal>(fractal), cage};
}

AffineMap<2> about(const Vector<2>& centre, double xx, double xy, double yx, double yy) {
    AffineMap<2> map = ifs::affineMap(xx, xy, yx, yy, 0, 0);
    map.translation = centre - map.linear * centre;
    return map;
}

std::optional<AffineMap<2>> changeOfAll(MapsArrangement arrangement, const Vector<2>& centre) {
    switch (arrangement) {
    case MapsArrangement::FlipLeftRight:
        return about(centre, -1, 0, 0, 1);
    case MapsArrangement::FlipUpDown:
        return about(centre, 1, 0, 0, -1);
    case MapsArrangement::RotateLeft:
        return about(centre, 0, -1, 1, 0);
    case MapsArrangement::RotateRight:
        return about(centre, 0, 1, -1, 0);
    default:
        return std::nullopt;
    }
}

// Offsets of the maps that bring their centres into a line, or space them evenly along the axis.
std::vector<Vector<2>> offsets(const std::vector<Vector<2>>& centres, int axis, bool isEven) {
    std::vector<Vector<2>> result(centres.size(), Vector<2>::Zero());
    if (!isEven) {
        const double middle = mean(centres)[axis];
        for (std::size_t k = 0; k < centres.size(); ++k)
            result[k][axis] = middle - centres[k][axis];
        return result;
    }
    std::vector<std::size_t> order(centres.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        order[k] = k;
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return centres[k][axis]; });
    const double first = centres[order.front()][axis], last = centres[order.back()][axis];
    for (std::size_t k = 1; k + 1 < order.size(); ++k)
        result[order[k]][axis] =
            first + (last - first) * double(k) / double(order.size() - 1) - centres[order[k]][axis];
    return result;
}

// The offset to the corner of the cage whose own image is nearest to it.
Vector<2> toNearestCorner(const std::vector<Vector<2>>& corners, const std::vector<Vector<2>>& cage) {
    Vector<2> nearest = cage.front() - corners.front();
    for (std::size_t k = 1; k < corners.size(); ++k)
        if (const Vector<2> way = cage[k] - corners[k]; way.norm() < nearest.norm()) nearest = way;
    return nearest;
}

QString stepText(MapsArrangement arrangement) {
    switch (arrangement) {
    case MapsArrangement::FlipLeftRight:
    case MapsArrangement::FlipUpDown:
        return Text::tr("Flip maps");
    case MapsArrangement::RotateLeft:
        return Text::tr("Rotate maps by 90°");
    case MapsArrangement::RotateRight:
        return Text::tr("Rotate maps by −90°");
    case MapsArrangement::AlignInRow:
    case MapsArrangement::AlignInColumn:
        return Text::tr("Align maps");
    case MapsArrangement::DistributeAcross:
    case MapsArrangement::DistributeUpwards:
        return Text::tr("Distribute maps");
    case MapsArrangement::FitToCorners:
        break;
    }
    return Text::tr("Fit maps to the corners");
}

std::size_t mapsNeeded(MapsArrangement arrangement) {
    switch (arrangement) {
    case MapsArrangement::AlignInRow:
    case MapsArrangement::AlignInColumn:
        return 2;
    case MapsArrangement::DistributeAcross:
    case MapsArrangement::DistributeUpwards:
        return 3;
    default:
        return 1;
    }
}

} // namespace

Fractal arranged(const Fractal& fractal, std::span<const std::size_t> indices, MapsArrangement arrangement) {
    const ifs::ControlCage<2> cage = effectiveCage(fractal);
    const MapHandles handles = handlesOf(fractal, cage);
    std::vector<Vector<2>> centres;
    for (const std::size_t index : indices)
        centres.push_back(mean(handles.corners(index)));
    if (centres.empty()) return fractal;
    if (const auto change = changeOfAll(arrangement, mean(centres)))
        return handles.withMapsChanged(indices, *change);
    std::vector<Vector<2>> ways;
    if (arrangement == MapsArrangement::FitToCorners)
        for (const std::size_t index : indices)
            ways.push_back(toNearestCorner(handles.corners(index), cage.current));
    else
        ways = offsets(centres,
                       arrangement == MapsArrangement::AlignInColumn ||
                               arrangement == MapsArrangement::DistributeAcross
                           ? 0
                           : 1,
                       arrangement == MapsArrangement::DistributeAcross ||
                           arrangement == MapsArrangement::DistributeUpwards);
    return handles.withMapsMoved(indices, ways);
}

std::optional<QString> arrangeMaps(Document& document, std::span<const std::size_t> indices,
                                   MapsArrangement arrangement) {
    if (!system2(document.fractal())) return Text::tr("Only maps in the plane can be arranged.");
    switch (const std::size_t needed = mapsNeeded(arrangement); indices.size() < needed ? needed : 0) {
    case 1:
        return Text::tr("Select a map first.");
    case 2:
        return Text::tr("Select at least two maps first.");
    case 3:
        return Text::tr("Select at least three maps first.");
    default:
        break;
    }
    if (QString locked = lockObstacle(document.fractal(), indices); !locked.isEmpty()) return locked;
    const ifs::ControlCage<2> cage = effectiveCage(document.fractal());
    if (!handlesOf(document.fractal(), cage).canBeMoved())
        return Text::tr("The cage is flat, so maps cannot be moved in it. Reset the cage first.");
    document.edit(stepText(arrangement), arranged(document.fractal(), indices, arrangement));
    return std::nullopt;
}

} // namespace document
