// SPDX-License-Identifier: MIT
#include "canvas/cage_tool.h"

#include "cage_edits.h"
#include "canvas/cage_actions.h"

#include <QKeyEvent>

#include <algorithm>
#include <numeric>

namespace view {

using Kind = CanvasPart::Kind;

std::optional<PolygonTool::Grip> CageTool::grip(const CanvasPart& part, PolygonDrag::Mode mode) {
    m_cage = *scene().cage();
    Grip grip{tr("Move the cage"), m_cage.current, {}};
    const int count = int(grip.points.size());
    if (mode == PolygonDrag::Mode::Move && part.kind == Kind::Vertex) {
        const std::vector<std::size_t> vertices = together(part);
        grip.vertices.assign(vertices.begin(), vertices.end());
        grip.text = vertices.size() == 1 ? tr("Move vertex %1").arg(part.index + 1)
                                         : tr("Move %1 vertices").arg(vertices.size());
        return grip;
    }
    if (mode == PolygonDrag::Mode::Move && part.kind == Kind::Edge) {
        grip.vertices = {part.index, (part.index + 1) % count};
        grip.text = tr("Move edge %1–%2").arg(grip.vertices[0] + 1).arg(grip.vertices[1] + 1);
        return grip;
    }
    grip.vertices.resize(std::size_t(count));
    std::iota(grip.vertices.begin(), grip.vertices.end(), 0);
    if (mode == PolygonDrag::Mode::Rotate) grip.text = tr("Rotate the cage");
    if (mode == PolygonDrag::Mode::Scale) grip.text = tr("Scale the cage");
    return grip;
}

double CageTool::preview(const std::function<DragResult(double)>& resultAt) {
    document::Fractal fractal = gesture().before();
    ifs::ControlCage<2> cage = m_cage;
    cage.current = resultAt(1).points;
    if (cage != m_cage)
        fractal = withCageMoved(std::move(fractal), std::move(cage), scene().document().cageMode());
    gesture().preview(std::move(fractal));
    return 1;
}

std::vector<std::size_t> CageTool::together(const CanvasPart& part) const {
    const std::vector<std::size_t>& selected = scene().selectedVertices();
    const auto vertex = std::size_t(part.index);
    const bool alone = part.kind == Kind::Vertex && std::ranges::find(selected, vertex) == selected.end();
    return alone ? std::vector{vertex} : selected;
}

std::optional<std::vector<std::size_t>> CageTool::selection() const {
    return scene().selectedVertices();
}

void CageTool::setSelection(const std::vector<std::size_t>& vertices) {
    scene().setSelectedVertices(vertices);
}

std::vector<std::size_t> CageTool::enclosedBy(const QRectF& band) const {
    std::vector<std::size_t> vertices;
    const QPolygonF polygon = scene().cagePolygon();
    for (int i = 0; i < polygon.size(); ++i)
        if (band.contains(polygon[i])) vertices.push_back(std::size_t(i));
    return vertices;
}

void CageTool::press(const Pointer& pointer) {
    m_pointer = pointer.position;
    m_focusedBefore = scene().focused();
    PolygonTool::press(pointer);
}

void CageTool::move(const Pointer& pointer) {
    m_pointer = pointer.position;
    PolygonTool::move(pointer);
}

void CageTool::taken(const CanvasPart& part, Qt::KeyboardModifiers modifiers) {
    if (part.kind == Kind::Vertex && !(modifiers & adding) && together(part).size() == 1) setSelection({});
}

// One vertex alone needs no selection: it has the focus.
void CageTool::clicked(const CanvasPart& part, const Pointer& pointer) {
    if (part.kind != Kind::Vertex || !(pointer.modifiers & adding)) return setSelection({});
    if (m_focusedBefore.kind == Kind::Vertex && m_focusedBefore != part && scene().selectedVertices().empty())
        setSelection({std::size_t(m_focusedBefore.index)});
    selectClicked(std::size_t(part.index), pointer.modifiers);
}

bool CageTool::keyPress(const QKeyEvent& event) {
    if (isBareKey(event, Qt::Key_Delete)) {
        const std::vector<std::size_t> vertices = together(scene().focused());
        if (vertices.empty())
            emit message(tr("Select a vertex first."));
        else if (const auto failure = removeVertices(scene().document(), vertices))
            emit message(*failure);
        return true;
    }
    if (isBareKey(event, Qt::Key_Insert)) {
        insertVertex();
        return true;
    }
    if (isBareKey(event, Qt::Key_Escape) && !scene().selectedVertices().empty()) {
        setSelection({});
        return true;
    }
    return PolygonTool::keyPress(event);
}

// On the edge under the pointer; else in the middle of the edge in focus, or of the one after the vertex in
// focus.
void CageTool::insertVertex() {
    const CanvasPart focused = scene().focused();
    if (scene().hovered().kind == Kind::Edge)
        insertVertexAt(scene().hovered().index, m_pointer);
    else if (focused.kind == Kind::Vertex || focused.kind == Kind::Edge)
        insertVertexAt(focused.index, scene().positionOf({Kind::Edge, focused.index}));
    else
        emit message(tr("Point at an edge, or select a vertex, to insert one."));
}

void CageTool::insertVertexAt(int edge, const QPointF& position) {
    const QPolygonF polygon = scene().cagePolygon();
    const QPointF from = polygon[edge];
    const QPointF along = polygon[(edge + 1) % polygon.size()] - from;
    const double length = QPointF::dotProduct(along, along);
    const double share = length > 0 ? QPointF::dotProduct(position - from, along) / length : 0.5;
    if (const auto failure = view::insertVertex(scene().document(), edge, std::clamp(share, 0.02, 0.98)))
        emit message(*failure);
    else
        scene().setFocused({Kind::Vertex, edge + 1});
}

} // namespace view
