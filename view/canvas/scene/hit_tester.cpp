// SPDX-License-Identifier: MIT
#include "canvas/scene/hit_tester.h"

#include "canvas/geometry/canvas_geometry.h"

#include <QLineF>

#include <algorithm>

namespace view {

namespace {

using Kind = CanvasPart::Kind;

struct Radii {
    double handle;
    double edge;
};

Radii radii(Reach reach) {
    return reach == Reach::Touch ? Radii{20, 14} : Radii{11, 6};
}

// The last of those nearest to a position.
class Nearest {
public:
    Nearest(const QPointF& position, double reach) : m_position(position), m_distance(reach) {}

    void consider(Kind kind, int index, const QPointF& at) {
        const double distance = QLineF(at, m_position).length();
        if (distance > m_distance) return;
        m_distance = distance;
        m_part = {kind, index};
    }
    const CanvasPart& part() const { return m_part; }
    double distance() const { return m_distance; }

private:
    QPointF m_position;
    double m_distance;
    CanvasPart m_part;
};

} // namespace

CanvasPart HitTester::vertexAt(const QPointF& position, double reach) const {
    if (m_handles.target() != HandleTarget::Cage) {
        const CanvasPart part = framePartAt(m_frames, position, reach, 0);
        return part.kind == Kind::Vertex ? part : CanvasPart();
    }
    Nearest nearest(position, reach);
    const QPolygonF polygon = pixelsOf(m_camera, m_handles.cage()->current);
    for (int i = 0; i < polygon.size(); ++i)
        nearest.consider(Kind::Vertex, i, polygon[i]);
    return nearest.part();
}

CanvasPart HitTester::partAt(const QPointF& position, Reach reach) const {
    if (!m_handles.cage()) return {};
    const auto [handle, edge] = radii(reach);
    Nearest gizmo(position, handle);
    if (m_handles.isAnythingHeld()) {
        gizmo.consider(Kind::Pivot, 0, m_gizmo.pivot);
        gizmo.consider(Kind::Scale, 0, m_gizmo.scale);
        gizmo.consider(Kind::Rotate, 0, m_gizmo.rotate);
    }
    // Vertices come before the pivot, which may lie anywhere.
    const CanvasPart vertex = vertexAt(position, handle);
    const bool isVertexFirst = gizmo.part().kind == Kind::None || gizmo.part().kind == Kind::Pivot ||
                               QLineF(positionOf(vertex), position).length() <= gizmo.distance();
    if (vertex.kind != Kind::None && isVertexFirst) return vertex;
    if (gizmo.part().kind != Kind::None) return gizmo.part();
    if (m_handles.target() != HandleTarget::Cage) return framePartAt(m_frames, position, handle, edge);
    const QPolygonF polygon = pixelsOf(m_camera, m_handles.cage()->current);
    CanvasPart nearestEdge;
    double least = edge;
    for (int i = 0; i < polygon.size(); ++i) {
        const double d = distanceToSegment(position, polygon[i], polygon[(i + 1) % polygon.size()]);
        if (d < least) {
            least = d;
            nearestEdge = {Kind::Edge, i};
        }
    }
    if (nearestEdge.kind == Kind::None && polygon.containsPoint(position, Qt::OddEvenFill))
        return {Kind::Inside, 0};
    return nearestEdge;
}

QPointF HitTester::positionOf(const CanvasPart& part) const {
    if (part.map >= 0) {
        if (part.map >= m_handles.childCount()) return {};
        const QPolygonF corners = pixelsOf(m_camera, m_handles.corners(part.map));
        if (part.kind == Kind::Vertex) return corners.value(part.index);
        QPointF sum;
        for (const QPointF& corner : corners)
            sum += corner;
        return sum / double(std::max<qsizetype>(1, corners.size()));
    }
    const QPolygonF polygon = m_handles.cage() ? pixelsOf(m_camera, m_handles.cage()->current) : QPolygonF();
    switch (part.kind) {
    case Kind::Vertex:
        return polygon.value(part.index);
    case Kind::Edge:
        return polygon.isEmpty() ? QPointF()
                                 : (polygon[part.index] + polygon[(part.index + 1) % polygon.size()]) / 2;
    case Kind::Rotate:
        return m_gizmo.rotate;
    case Kind::Scale:
        return m_gizmo.scale;
    case Kind::Inside:
    case Kind::Pivot:
    case Kind::None:
        break;
    }
    return m_gizmo.pivot;
}

std::vector<std::size_t> HitTester::mapsWithin(const QRectF& band) const {
    std::vector<std::size_t> indices;
    const document::MapHandles* maps = m_handles.maps();
    if (!maps) return indices;
    std::vector<document::Box> boxes; // boxes of maps without frames
    if (m_frames.size() < maps->count()) boxes = maps->boxes();
    for (std::size_t index = 0; index < maps->count(); ++index) {
        const MapFrame* frame = frameOf(m_frames, int(index));
        if (frame ? band.contains(frame->outline.boundingRect())
                  : band.contains(pixelsOf(m_camera, boxes[index].min, boxes[index].max).center()) &&
                        band.contains(pixelsOf(m_camera, maps->outline(index)).boundingRect()))
            indices.push_back(index);
    }
    return indices;
}

} // namespace view
