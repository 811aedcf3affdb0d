// SPDX-License-Identifier: MIT
#include "canvas/items/cage_item.h"

#include "canvas/items/vertex_handle.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace view {

CageItem::CageItem() = default;
CageItem::~CageItem() = default;

void CageItem::setPolygon(const QPolygonF& polygon) {
    prepareGeometryChange();
    m_polygon = polygon;
    while (int(m_handles.size()) > polygon.size())
        m_handles.pop_back();
    while (int(m_handles.size()) < polygon.size()) {
        m_handles.push_back(std::make_unique<VertexHandle>(int(m_handles.size()) + 1, this));
        m_handles.back()->setStyle(m_style);
        m_handles.back()->setVisible(!m_quiet);
    }
    for (std::size_t i = 0; i < m_handles.size(); ++i)
        m_handles[i]->setPos(polygon[int(i)]);
    update();
}

void CageItem::setMarks(CanvasPart hovered, CanvasPart pressed, CanvasPart focused) {
    const auto own = [](CanvasPart part) { return part.map < 0 ? part : CanvasPart(); };
    HandlesItem::setMarks(own(hovered), own(pressed), own(focused));
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        const CanvasPart self{CanvasPart::Kind::Vertex, int(i)};
        HandleStates state;
        state.setFlag(HandleState::Hovered, hovered == self);
        state.setFlag(HandleState::Pressed, pressed == self);
        state.setFlag(HandleState::Focused, focused == self);
        state.setFlag(HandleState::Selected, std::ranges::find(m_selected, i) != m_selected.end());
        m_handles[i]->setState(state);
    }
}

void CageItem::setSelected(const std::vector<std::size_t>& vertices) {
    m_selected = vertices;
    setMarks(m_hovered, m_pressed, m_focused);
}

void CageItem::setStyle(const OverlayStyle& style) {
    HandlesItem::setStyle(style);
    for (const auto& handle : m_handles)
        handle->setStyle(style);
}

void CageItem::setQuiet(bool quiet) {
    m_quiet = quiet;
    setOpacity(quiet ? 0.5 : 1);
    for (const auto& handle : m_handles)
        handle->setVisible(!quiet);
    update();
}

QRectF CageItem::boundingRect() const {
    return m_polygon.boundingRect().adjusted(-16, -16, 16, 16); // room for the sides of a flat cage
}

void CageItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (m_polygon.isEmpty()) return;
    painter->setRenderHint(QPainter::Antialiasing);
    QPainterPath outline;
    // Parallel lines for a flat cage, whose edges would hide the picture on them.
    const QList<QLineF> sides = sidesOfFlat(m_polygon);
    for (const QLineF& side : sides) {
        outline.moveTo(side.p1());
        outline.lineTo(side.p2());
    }
    if (sides.isEmpty()) {
        outline.addPolygon(m_polygon);
        outline.closeSubpath();
    }
    strokeWithHalo(*painter, outline, m_style, m_style.line, m_style.lineWidth);

    if (m_focused.kind == CanvasPart::Kind::Inside)
        strokeLit(*painter, outline, m_style, m_style.lineWidth, Qt::DashLine);
    const auto light = [&](const CanvasPart& part, double width) {
        if (part.kind != CanvasPart::Kind::Edge || part.index >= m_polygon.size()) return;
        if (!sides.isEmpty()) return strokeLit(*painter, outline, m_style, width);
        QPainterPath edge(m_polygon[part.index]);
        edge.lineTo(m_polygon[(part.index + 1) % m_polygon.size()]);
        strokeLit(*painter, edge, m_style, width);
    };
    light(m_focused, m_style.lineWidth);
    light(m_pressed.kind == CanvasPart::Kind::None ? m_hovered : m_pressed, m_style.lineWidth + 1);
}

} // namespace view
