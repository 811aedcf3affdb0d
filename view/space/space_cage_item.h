// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "canvas/items/vertex_handle.h"
#include "ifs/cage/control_cage.h"

#include <QPolygonF>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace view {

// The control tetrahedron: edges on its far side are dashed, a handle at every vertex, hollow where the
// attractor hides it.
class SpaceCageItem : public OverlayItem {
public:
    // Whether something is in front of a point of the screen.
    using Hidden = std::function<bool(const attractor::ScreenPoint&)>;
    void layOut(const attractor::OrbitCamera& camera, const std::vector<ifs::Vector<3>>& vertices,
                const Hidden& isHidden);
    void setMarks(std::optional<std::size_t> hovered, std::optional<std::size_t> pressed,
                  std::optional<std::size_t> focused);

    // Of two handles there, the nearer one; the others follow.
    std::vector<std::size_t> handlesAt(const QPointF& position) const;
    QPointF handle(std::size_t vertex) const { return m_points[qsizetype(vertex)]; }
    std::size_t count() const { return m_handles.size(); }
    const std::vector<ifs::Vector<3>>& vertices() const { return m_vertices; }

    void setStyle(const OverlayStyle& style) override;
    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    struct Edge {
        QLineF line;
        bool isBehind = false;
    };
    std::vector<ifs::Vector<3>> m_vertices;
    QPolygonF m_points;
    std::vector<double> m_depths;
    std::vector<Edge> m_edges;
    std::vector<bool> m_hidden;
    std::vector<std::unique_ptr<VertexHandle>> m_handles;
    std::optional<std::size_t> m_hovered;
    std::optional<std::size_t> m_pressed;
    std::optional<std::size_t> m_focused;
};

} // namespace view
