// SPDX-License-Identifier: MIT
#include "canvas/canvas_input.h"

#include "canvas/items/border_arrows_item.h"
#include "document/branches/addresses.h"
#include "widgets/arrow_keys.h"

#include <QKeyEvent>
#include <QWheelEvent>

#include <utility>

namespace view {

namespace {

constexpr double keyZoom = 1.25;
constexpr double keyPan = 40;    // pixels
constexpr double notchTurn = 5;  // degrees
constexpr double clickSlack = 2; // pixels, as in drags of tools
constexpr Qt::KeyboardModifiers turning = Qt::ControlModifier | Qt::ShiftModifier;

} // namespace

bool CanvasInput::needsKey(const QKeyEvent& event) const {
    return ViewportInput::needsKey(event) ||
           (event.key() == Qt::Key_Backspace && m_tools.tool() == Toolbox::Tool::DefineTriangle);
}

bool CanvasInput::wheelTurned(const QWheelEvent& event) {
    if ((event.modifiers() & turning) == turning) {
        m_navigation.rotateAt(event.position(), notchTurn * notches(event));
        return true;
    }
    const bool chooses =
        m_tools.tool() == Toolbox::Tool::Branch && event.modifiers().testFlag(Qt::ShiftModifier);
    if (chooses) m_tools.branchTool().choice().turnDepth(event.angleDelta().y() + event.angleDelta().x());
    return chooses;
}

void CanvasInput::reportPointer() {
    PointerPosition position = pointerPosition(m_scene, pointer().position);
    if (!isHolding()) findAddress(position, m_scene, m_tools.branchTool().choice().depth());
    emit pointerMoved(position);
}

bool CanvasInput::pressed(Qt::MouseButton button) {
    if (button != Qt::LeftButton) return false;
    const bool takesPolygons = m_tools.tool() == Toolbox::Tool::Cage || m_tools.tool() == Toolbox::Tool::Maps;
    const CanvasPart::Kind kind = m_scene.partAt(pointer().position, pointer().reach).kind;
    const bool isHandle = kind != CanvasPart::Kind::None && kind != CanvasPart::Kind::Inside;
    m_clicked.reset();
    if (m_scene.overlaysVisible() && !isHandle && m_scene.notes().dismissAt(pointer().position)) return false;
    if (arrowUnder() && !m_tools.active().isBusy()) {
        m_navigation.fitCorners();
        return false;
    }
    if (takesPolygons && !isHandle && m_scene.overlaysVisible()) m_clicked = pointer().position;
    m_tools.toolAt(pointer()).press(pointer());
    return true;
}

bool CanvasInput::doubleClicked() {
    const CanvasPart part = m_scene.partAt(pointer().position, Reach::Mouse);
    if (m_tools.tool() == Toolbox::Tool::Cage && part.kind == CanvasPart::Kind::Edge)
        m_tools.cageTool().insertVertexAt(part.index, pointer().position);
    return false; // may be dragged at once
}

QCursor CanvasInput::cursorOver() const {
    const bool isArrow = !isHolding() && arrowUnder();
    return isArrow ? QCursor(Qt::PointingHandCursor) : m_tools.toolAt(pointer()).cursor(pointer());
}

void CanvasInput::left() {
    m_scene.marks().borderArrows().setHovered(-1);
    m_tools.active().leave();
}

void CanvasInput::moved() {
    if (m_clicked && (pointer().position - *m_clicked).manhattanLength() > clickSlack) m_clicked.reset();
    m_tools.active().move(pointer());
    markArrow();
    reportPointer();
}

// The arrow under the pointer to a corner outside, unless a handle lies over it.
std::optional<BorderArrow> CanvasInput::arrowUnder() const {
    using Kind = CanvasPart::Kind;
    const BorderArrowsItem& arrows = m_scene.marks().borderArrows();
    const Kind kind = m_scene.partAt(pointer().position, pointer().reach).kind;
    const bool isFree = kind == Kind::None || kind == Kind::Inside || kind == Kind::Edge;
    if (!arrows.isVisible() || !isFree) return std::nullopt;
    return arrows.arrowAt(pointer().position, pointer().reach == Reach::Touch ? BorderArrowsItem::fingerReach
                                                                              : BorderArrowsItem::mouseReach);
}

void CanvasInput::markArrow() {
    const auto arrow = isHolding() ? std::nullopt : arrowUnder();
    BorderArrowsItem& arrows = m_scene.marks().borderArrows();
    const int before = arrows.hovered();
    arrows.setHovered(arrow ? arrow->vertex : -1);
    if (before < 0 && arrow) emit message(cornerOutside());
    if (before >= 0 && !arrow) emit message({});
}

void CanvasInput::released() {
    m_tools.active().release(pointer());
    endClick();
}

// A click that is no drag chooses the cylinder there, if an analysis outlines them.
void CanvasInput::endClick() {
    if (!m_clicked || !m_scene.marks().chooseCylinderAt(*std::exchange(m_clicked, {}))) return;
    const auto walk = m_scene.marks().cylinderWalk();
    emit message(walk.empty()
                     ? QString()
                     : tr("Cylinder %1").arg(document::addressText(walk.back()->listed, walk.size())));
}

void CanvasInput::cancelDrag() {
    m_clicked.reset();
    if (m_tools.polygonTool()) m_tools.active().cancel();
}

bool CanvasInput::cancelled() {
    if (!m_tools.active().isBusy() && m_tools.polygonTool()) return false;
    return m_tools.active().cancel();
}

bool CanvasInput::keyPressed(const QKeyEvent& event) {
    return m_tools.active().keyPress(event) || canvasKey(event);
}

// Handles keys that the canvas knows whatever the tool; true if it did.
bool CanvasInput::canvasKey(const QKeyEvent& event) {
    if (const QPointF way = -arrowDirection(event.key()); !way.isNull()) {
        m_navigation.pan(way * (event.modifiers().testFlag(Qt::ShiftModifier) ? 5 * keyPan : keyPan));
        return true;
    }
    if (event.key() == Qt::Key_Escape) {
        if (cancelGesture() || m_scene.notes().dismiss()) return true;
        const bool focused = m_scene.selection().focused().kind != CanvasPart::Kind::None;
        m_scene.selection().setFocused({});
        return focused;
    }
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
    switch (event.key()) {
    case Qt::Key_F:
        m_navigation.fit();
        return true;
    case Qt::Key_1:
        m_navigation.resetZoom();
        return true;
    case Qt::Key_H:
        m_options.setOverlaysVisible(!m_options.overlaysVisible());
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        m_navigation.zoomBy(keyZoom);
        return true;
    case Qt::Key_Minus:
        m_navigation.zoomBy(1 / keyZoom);
        return true;
    default:
        return false;
    }
}

} // namespace view
