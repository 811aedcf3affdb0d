// SPDX-License-Identifier: MIT
#include "canvas/tools/cage_tool.h"

#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"

#include <QKeyEvent>

#include <algorithm>
#include <numeric>

namespace view {

using Kind = CanvasPart::Kind;

std::optional<PolygonTool::DragSubject> CageTool::dragSubject(const CanvasPart& part,
                                                              PolygonDrag::Mode mode) {
    if (const QString obstacle = moveCageObstacle(scene().document()); !obstacle.isEmpty()) {
        emit message(obstacle);
        return std::nullopt;
    }
    m_cage = *handles().cage();
    DragSubject subject{tr("Move the cage"), m_cage.current, {}};
    const int count = int(subject.points.size());
    if (mode == PolygonDrag::Mode::Move && part.kind == Kind::Vertex) {
        const std::vector<std::size_t> vertices = together(part);
        subject.vertices.assign(vertices.begin(), vertices.end());
        subject.text = vertices.size() == 1 ? tr("Move vertex %1").arg(part.index + 1)
                                            : tr("Move %1 vertices").arg(vertices.size());
        return subject;
    }
    if (mode == PolygonDrag::Mode::Move && part.kind == Kind::Edge) {
        subject.vertices = {part.index, (part.index + 1) % count};
        subject.text = tr("Move edge %1–%2").arg(subject.vertices[0] + 1).arg(subject.vertices[1] + 1);
        return subject;
    }
    subject.vertices.resize(std::size_t(count));
    std::iota(subject.vertices.begin(), subject.vertices.end(), 0);
    if (mode == PolygonDrag::Mode::Rotate) subject.text = tr("Rotate the cage");
    if (mode == PolygonDrag::Mode::Scale) subject.text = tr("Scale the cage");
    return subject;
}

PolygonTool::Shown CageTool::preview(const std::function<DragResult(double)>& resultAt) {
    document::Fractal fractal = gesture().before();
    ifs::ControlCage<2> cage = m_cage;
    Shown shown{1, resultAt(1)};
    cage.current = shown.result.points;
    if (cage != m_cage)
        fractal = withCageMoved(std::move(fractal), std::move(cage), scene().document().cageMode());
    gesture().preview(std::move(fractal));
    return shown;
}

std::vector<std::size_t> CageTool::together(const CanvasPart& part) const {
    const std::vector<std::size_t>& selected = selection().vertices();
    const auto vertex = std::size_t(part.index);
    const bool alone = part.kind == Kind::Vertex && std::ranges::find(selected, vertex) == selected.end();
    return alone ? std::vector{vertex} : selected;
}

std::optional<std::vector<std::size_t>> CageTool::selectedItems() const {
    return selection().vertices();
}

void CageTool::selectItems(const std::vector<std::size_t>& vertices) {
    selection().setVertices(vertices);
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
    m_focusedBefore = selection().focused();
    PolygonTool::press(pointer);
}

void CageTool::move(const Pointer& pointer) {
    m_pointer = pointer.position;
    PolygonTool::move(pointer);
}

void CageTool::pressed(const CanvasPart& part, Qt::KeyboardModifiers modifiers) {
    if (part.kind == Kind::Vertex && !(modifiers & adding) && together(part).size() == 1) selectItems({});
}

// A single vertex needs no selection: it has the focus.
void CageTool::clicked(const CanvasPart& part, const Pointer& pointer) {
    if (part.kind != Kind::Vertex || !(pointer.modifiers & adding)) return selectItems({});
    if (m_focusedBefore.kind == Kind::Vertex && m_focusedBefore != part && selection().vertices().empty())
        selectItems({std::size_t(m_focusedBefore.index)});
    selectClicked(std::size_t(part.index), pointer.modifiers);
}

bool CageTool::keyPress(const QKeyEvent& event) {
    if (isBareKey(event, Qt::Key_Delete)) {
        const std::vector<std::size_t> vertices = together(selection().focused());
        if (vertices.empty())
            emit message(tr("Select a corner first."));
        else if (const auto failure = removeVertices(scene().document(), vertices))
            emit message(*failure);
        return true;
    }
    if (isBareKey(event, Qt::Key_Insert)) {
        insertVertex();
        return true;
    }
    if (isBareKey(event, Qt::Key_Escape) && !selection().vertices().empty()) {
        selectItems({});
        return true;
    }
    return PolygonTool::keyPress(event);
}

// Inserts on the edge under the pointer; else in the middle of the edge in focus, or of the one after the
// vertex in focus.
void CageTool::insertVertex() {
    const CanvasPart focused = selection().focused();
    if (selection().hovered().kind == Kind::Edge)
        insertVertexAt(selection().hovered().index, m_pointer);
    else if (focused.kind == Kind::Vertex || focused.kind == Kind::Edge)
        insertVertexAt(focused.index, scene().positionOf({Kind::Edge, focused.index}));
    else
        emit message(tr("To insert a corner, point to an edge or select a corner."));
}

void CageTool::insertVertexAt(int edge, const QPointF& position) {
    const QPolygonF polygon = scene().cagePolygon();
    const QPointF from = polygon[edge];
    const QPointF along = polygon[(edge + 1) % polygon.size()] - from;
    const double length = QPointF::dotProduct(along, along);
    const double share = length > 0 ? QPointF::dotProduct(position - from, along) / length : 0.5;
    if (const auto failure = document::insertVertex(scene().document(), edge, std::clamp(share, 0.02, 0.98)))
        emit message(*failure);
    else
        selection().setFocused({Kind::Vertex, edge + 1});
}

} // namespace view
