// SPDX-License-Identifier: MIT
#include "space/space_cage_item.h"

#include "canvas/geometry/canvas_geometry.h"
#include "ifs/cage/cage_surface.h"
#include "space/seen_line.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace view {

namespace {

constexpr double grip = 12; // pixels around a handle that hold it

using attractor::OrbitCamera;
using ifs::Vector;

// The turn() of a face of which some corners may be behind the eye.
double turnInSpace(const OrbitCamera& camera, const std::vector<Vector<3>>& vertices,
                   const std::vector<int>& face) {
    const Vector<3> eye =
        camera.target + eyeDistance(camera) * (camera.orientation * Vector<3>::UnitZ()).eval();
    double sum = 0;
    const auto at = [&](std::size_t k) { return Vector<3>(vertices[std::size_t(face[k])] - eye); };
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
        sum += at(0).dot(at(k).cross(at(k + 1)));
    return sum;
}

using Faces = SpaceCageItem::Faces;

// Twice the area on the screen, where y grows downwards: negative where the corners run counter-clockwise.
double turn(const QPolygonF& points, const std::vector<int>& face) {
    double doubled = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
        const QPointF& p = points[face[k]];
        const QPointF& q = points[face[(k + 1) % face.size()]];
        doubled += p.x() * q.y() - p.y() * q.x();
    }
    return doubled;
}

// Negative where the cage is turned inside out, 0 where it is flat.
double volume(const std::vector<ifs::Vector<3>>& vertices, const Faces& faces) {
    double six = 0;
    for (const std::vector<int>& face : faces) {
        const auto at = [&](std::size_t k) {
            return ifs::Vector<3>(vertices[std::size_t(face[k % face.size()])] - vertices[0]);
        };
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            six += at(0).dot(at(k).cross(at(k + 1)));
    }
    return six;
}

} // namespace

Faces SpaceCageItem::facesOf(const std::vector<ifs::Vector<3>>& rest) {
    if (auto surface = ifs::convexSurface(rest)) return std::move(surface->faces);
    if (rest.size() < 4) return {};
    return {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
}

// An edge is behind where both of its faces are turned away.
void SpaceCageItem::layOutEdges(const attractor::OrbitCamera& camera, const Faces& faces) {
    m_edges.clear();
    m_faces.clear();
    const double inside = volume(m_vertices, faces);
    std::map<std::pair<int, int>, bool> isSeen;
    for (const std::vector<int>& face : faces) {
        const bool isWhole = std::ranges::all_of(
            face, [&](int corner) { return inFront(camera, m_vertices[std::size_t(corner)]) > 0; });
        const double turned = isWhole ? turn(m_points, face) : turnInSpace(camera, m_vertices, face);
        const bool isTowards = turned * inside <= 0;
        for (std::size_t k = 0; k < face.size(); ++k)
            isSeen[std::minmax(face[k], face[(k + 1) % face.size()])] |= isTowards;
        QPointF sum;
        for (const int corner : face)
            sum += m_points[corner];
        m_faces.push_back({face, sum / double(face.size()), isTowards && isWhole && inside != 0});
    }
    for (const auto& [edge, seen] : isSeen)
        if (const auto line =
                seenLine(camera, m_vertices[std::size_t(edge.first)], m_vertices[std::size_t(edge.second)]))
            m_edges.push_back({*line, !seen});
}

void SpaceCageItem::layOut(const attractor::OrbitCamera& camera, const std::vector<ifs::Vector<3>>& vertices,
                           const Faces& faces, const Hidden& isHidden) {
    prepareGeometryChange();
    m_vertices = vertices;
    m_points.clear();
    m_depths.clear();
    m_hidden.clear();
    std::vector<ifs::Vector<2>> pixels;
    for (const ifs::Vector<3>& vertex : vertices) {
        const attractor::ScreenPoint seen = toScreen(camera, vertex);
        m_points << seenPoint(camera, vertex);
        pixels.push_back(toVector(m_points.back()));
        m_depths.push_back(seen.depth);
        m_hidden.push_back(isHidden(seen));
    }
    layOutEdges(camera, vertices.empty() ? Faces() : faces);
    int corners = 0;
    for (const std::vector<int>& face : faces)
        corners = std::max(corners, *std::ranges::max_element(face) + 1);
    while (m_handles.size() > pixels.size())
        m_handles.pop_back();
    while (m_handles.size() < pixels.size()) {
        const bool isCorner = int(m_handles.size()) < corners;
        m_handles.push_back(std::make_unique<VertexHandle>(isCorner ? int(m_handles.size()) + 1 : 0, this));
        m_handles.back()->setStyle(m_style);
        m_handles.back()->setVisible(m_showsHandles);
    }
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        m_handles[i]->setPos(m_points[qsizetype(i)]);
        m_handles[i]->setZValue(-m_depths[i]);
    }
    setMarks(m_hovered, m_pressed, m_focused);
    update();
}

void SpaceCageItem::setHandlesVisible(bool visible) {
    m_showsHandles = visible;
    for (const auto& handle : m_handles)
        handle->setVisible(visible);
}

void SpaceCageItem::setFill(const QColor& fill) {
    m_fill = fill;
    update();
}

void SpaceCageItem::setMarks(std::optional<std::size_t> hovered, std::optional<std::size_t> pressed,
                             std::optional<std::size_t> focused) {
    m_hovered = hovered;
    m_pressed = pressed;
    m_focused = focused;
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        HandleStates state;
        state.setFlag(HandleState::Hovered, hovered == i);
        state.setFlag(HandleState::Pressed, pressed == i);
        state.setFlag(HandleState::Focused, focused == i);
        state.setFlag(HandleState::Hidden, m_hidden[i]);
        m_handles[i]->setState(state);
    }
}

std::vector<std::size_t> SpaceCageItem::handlesAt(const QPointF& position) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < m_handles.size(); ++i)
        if (QLineF(handle(i), position).length() <= grip) found.push_back(i);
    std::ranges::sort(found, {}, [this](std::size_t i) { return m_depths[i]; });
    return found;
}

std::optional<std::size_t> SpaceCageItem::faceAt(const QPointF& position) const {
    constexpr double reach = 9; // pixels
    for (std::size_t i = 0; m_holdsFaces && m_showsHandles && i < m_faces.size(); ++i)
        if (m_faces[i].isTowards && QLineF(m_faces[i].middle, position).length() <= reach) return i;
    return std::nullopt;
}

void SpaceCageItem::setFaceMark(std::optional<std::size_t> face) {
    if (face == m_faceMark) return;
    m_faceMark = face;
    update();
}

void SpaceCageItem::setStyle(const OverlayStyle& style) {
    OverlayItem::setStyle(style);
    for (const auto& handle : m_handles)
        handle->setStyle(style);
}

// Paints in one stroke, so that nothing is covered twice.
void SpaceCageItem::paintFaces(QPainter& painter) const {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const Face& face : m_faces) {
        if (!face.isTowards) continue;
        QPolygonF corners;
        for (const int corner : face.corners)
            corners << m_points[corner];
        path.addPolygon(corners);
    }
    painter.fillPath(path, m_fill);
}

QRectF SpaceCageItem::boundingRect() const {
    QPolygonF all = m_points;
    for (const Edge& edge : m_edges)
        all << edge.line.p1() << edge.line.p2();
    return all.boundingRect().adjusted(-6, -6, 6, 6);
}

void SpaceCageItem::paintFaceHandles(QPainter& painter) const {
    constexpr double radius = 5;
    painter.setPen(QPen(m_style.rim, m_style.lineWidth * 0.75));
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
        if (!m_faces[i].isTowards) continue;
        const QPointF& at = m_faces[i].middle;
        painter.setBrush(m_faceMark == i ? m_style.accent : m_style.core);
        painter.drawPolygon(QPolygonF{at + QPointF(0, -radius), at + QPointF(radius, 0),
                                      at + QPointF(0, radius), at + QPointF(-radius, 0)});
    }
}

void SpaceCageItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    if (m_fill.isValid()) paintFaces(*painter);
    for (const bool behind : {true, false}) {
        QPainterPath path;
        for (const Edge& edge : m_edges)
            if (edge.isBehind == behind) {
                path.moveTo(edge.line.p1());
                path.lineTo(edge.line.p2());
            }
        strokeWithHalo(*painter, path, m_style, m_style.line,
                       behind ? m_style.lineWidth / 2 : m_style.lineWidth,
                       behind ? Qt::DashLine : Qt::SolidLine);
    }
    if (m_holdsFaces && m_showsHandles) paintFaceHandles(*painter);
}

} // namespace view
