// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "canvas/items/vertex_handle.h"
#include "ifs/cage/control_cage.h"

#include <QColor>
#include <QPolygonF>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace view {

// A control cage: edges on its far side are dashed, a handle at every vertex, hollow where the attractor
// hides it. A vertex beyond the corners of its faces is one in its middle, without a number.
class SpaceCageItem : public OverlayItem {
public:
    // Returns true if something is in front of a point of the screen.
    using Hidden = std::function<bool(const attractor::ScreenPoint&)>;
    // The corners of each face, counter-clockwise seen from outside.
    using Faces = std::vector<std::vector<int>>;
    static Faces facesOf(const std::vector<ifs::Vector<3>>& rest);
    void layOut(const attractor::OrbitCamera& camera, const std::vector<ifs::Vector<3>>& vertices,
                const Faces& faces, const Hidden& isHidden);
    void setMarks(std::optional<std::size_t> hovered, std::optional<std::size_t> pressed,
                  std::optional<std::size_t> focused);

    // Handles at a position, the nearest first.
    std::vector<std::size_t> handlesAt(const QPointF& position) const;
    // The face towards the eye that has its middle there; nullopt without one.
    std::optional<std::size_t> faceAt(const QPointF& position) const;
    const std::vector<int>& face(std::size_t index) const { return m_faces[index].corners; }
    QPointF faceHandle(std::size_t index) const { return m_faces[index].middle; }
    void setFaceMark(std::optional<std::size_t> face); // hovered or held face
    void setFacesHeld(bool held) { m_holdsFaces = held; }
    QPointF handle(std::size_t vertex) const { return m_points[qsizetype(vertex)]; }
    const QPolygonF& handles() const { return m_points; }
    std::size_t count() const { return m_handles.size(); }
    const std::vector<ifs::Vector<3>>& vertices() const { return m_vertices; }

    void setHandlesVisible(bool visible); // false: edges alone
    void setFill(const QColor& fill);     // colour of the faces towards the eye; invalid: none
    QColor fill() const { return m_fill; }

    void setStyle(const OverlayStyle& style) override;
    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    struct Edge {
        QLineF line;
        bool isBehind = false;
    };
    struct Face {
        std::vector<int> corners;
        QPointF middle;
        bool isTowards = false;
    };
    void layOutEdges(const attractor::OrbitCamera& camera, const Faces& faces);
    void paintFaces(QPainter& painter) const;
    void paintFaceHandles(QPainter& painter) const;
    std::vector<ifs::Vector<3>> m_vertices;
    QPolygonF m_points;
    std::vector<double> m_depths;
    std::vector<Edge> m_edges;
    std::vector<bool> m_hidden;
    std::vector<std::unique_ptr<VertexHandle>> m_handles;
    std::vector<Face> m_faces;
    std::optional<std::size_t> m_faceMark;
    QColor m_fill;
    bool m_holdsFaces = false;
    bool m_showsHandles = true;
    std::optional<std::size_t> m_hovered;
    std::optional<std::size_t> m_pressed;
    std::optional<std::size_t> m_focused;
};

} // namespace view
