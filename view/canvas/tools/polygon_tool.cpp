// SPDX-License-Identifier: MIT
#include "canvas/tools/polygon_tool.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/geometry/drag_text.h"
#include "canvas/scene/canvas_cursors.h"
#include "canvas/scene/handle_text.h"
#include "widgets/arrow_keys.h"

#include <QKeyEvent>
#include <QLineF>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace view {

namespace {

using Kind = CanvasPart::Kind;

PolygonDrag::Mode modeOf(const CanvasPart& part, Qt::KeyboardModifiers modifiers) {
    if (part.kind == Kind::Rotate) return PolygonDrag::Mode::Rotate;
    if (part.kind == Kind::Scale) return PolygonDrag::Mode::Scale;
    return dragMode(modifiers);
}

int nearestVertex(const PolygonDrag& drag) {
    return *std::ranges::min_element(drag.vertices, {}, [&](int vertex) {
        return (drag.points[std::size_t(vertex)] - drag.press).squaredNorm();
    });
}

Constraint constraintOf(Qt::KeyboardModifiers modifiers) {
    return modifiers.testFlag(Qt::ShiftModifier) ? Constraint::Constrained : Constraint::Free;
}

} // namespace

PolygonTool::PolygonTool(CanvasScene& scene) : m_scene(scene), m_session(scene.document()) {
    connect(&m_session, &DragSession::runEnded, this, &PolygonTool::end);
}

PolygonTool::~PolygonTool() = default;

void PolygonTool::press(const Pointer& pointer) {
    end();
    // A press on a key of a path shows its moment, so that the keyed part can be dragged there.
    const auto key = m_scene.keyAt(pointer.position, pointer.reach);
    if (key) m_scene.document().setMoment(animation::moment(key->frame));
    m_part = key ? key->part : m_scene.partAt(pointer.position, pointer.reach);
    selection().setFocused(m_part);
    if (!handles().cage() || !m_scene.overlaysVisible()) return;
    m_session.press(pointer.position);
    m_camera = m_scene.camera();
    m_pivotAtPress = handles().pivot();
    m_ownPivotAtPress = handles().hasOwnPivot();
    const bool transforms = pointer.modifiers & (Qt::ControlModifier | Qt::AltModifier);
    if (m_part.kind == Kind::None && !transforms) {
        const std::optional<std::vector<std::size_t>> selected = selectedItems();
        if (!selected) return;
        m_selectionAtPress = *selected;
        m_state = State::Selecting;
        selectWithin(pointer);
        return;
    }
    m_state = State::Pressed;
    m_drag = {};
    m_drag.mode = modeOf(m_part, pointer.modifiers);
    selection().setPressed(m_part);
    pressed(m_part, pointer.modifiers);
    emit cursorChanged();
}

void PolygonTool::move(const Pointer& pointer) {
    switch (m_state) {
    case State::Idle:
    case State::Nudging: {
        const auto key = m_scene.keyAt(pointer.position, pointer.reach);
        hover(key ? key->part : m_scene.partAt(pointer.position, pointer.reach));
        return;
    }
    case State::Cancelled:
        return;
    case State::Selecting:
        selectWithin(pointer);
        return;
    case State::Pressed:
        if (!m_session.isDrag(pointer.position)) return;
        if (m_part.kind == Kind::Pivot && m_drag.mode == PolygonDrag::Mode::Move) {
            m_state = State::MovingPivot;
        } else if (open(m_part, m_drag.mode, m_session.pressedAt())) {
            m_state = State::Dragging;
        } else {
            end();
            m_state = State::Cancelled;
            return;
        }
        emit dragStarted();
        break;
    case State::Dragging:
        if (const auto mode = m_session.turnedInto(modeOf(m_part, pointer.modifiers), m_drag.mode))
            turnInto(*mode);
        break;
    case State::MovingPivot:
        break;
    }
    if (m_state == State::MovingPivot)
        movePivot(pointer);
    else
        dragTo(pointer);
}

bool PolygonTool::open(const CanvasPart& part, PolygonDrag::Mode mode, const QPointF& press) {
    std::optional<DragSubject> subject = dragSubject(part, mode);
    if (!subject) return false;
    m_drag = {mode, std::move(subject->points), std::move(subject->vertices)};
    m_drag.pivot = handles().pivot();
    m_drag.press = worldAt(m_scene.camera(), press);
    m_drag.snapVertex = nearestVertex(m_drag);
    m_session.open(subject->text);
    return true;
}

void PolygonTool::turnInto(PolygonDrag::Mode mode) {
    m_session.cancel();
    restorePivot();
    const ifs::Vector<2> press = m_drag.press;
    // Independent of later changes of the view.
    if (open(m_part, mode, m_session.pressedAt())) m_drag.press = press;
}

void PolygonTool::dragTo(const Pointer& pointer) {
    if (!m_session.isOpen()) { // ended by another change of the document
        settle();
        end();
        m_state = State::Cancelled;
        return;
    }
    const CanvasScene::Batch batch(m_scene);
    m_pointer = pointer.position;
    // Reference in the plane, because zooming during a drag changes the size of a pixel.
    const ifs::Vector<2> offset =
        m_camera == m_scene.camera()
            ? worldOffset(m_camera, pointer.position - m_session.pressedAt())
            : ifs::Vector<2>(worldAt(m_scene.camera(), pointer.position) - m_drag.press);
    if (m_part.kind == Kind::Rotate || m_part.kind == Kind::Scale) m_scene.holdKnobAt(pointer.position);
    const Constraint constraint = constraintOf(pointer.modifiers);
    SnapTargets targets = m_scene.snapTargets(m_part, m_drag.vertices);
    const Snapping snapping = targets.snapping;
    show([&](double share) {
        targets.snapping = share < 1 ? Snapping() : snapping; // no snapping before the requested position
        return dragged(m_drag, offset * share, constraint, targets);
    });
}

double PolygonTool::show(const std::function<DragResult(double)>& resultAt) {
    const CanvasScene::Batch batch(m_scene);
    const Shown shown = preview(resultAt);
    const bool whole = m_drag.vertices.size() == m_drag.points.size();
    if (m_ownPivotAtPress && whole && m_drag.mode == PolygonDrag::Mode::Move)
        handles().setPivot(m_pivotAtPress + shown.result.change.translation);
    m_scene.marks().showSnap(shown.result.snap);
    if (m_state == State::Dragging) m_scene.marks().showReadout(readout(m_drag, shown.result), m_pointer);
    describe(shown.result);
    return shown.share;
}

// Describes the drag and its value.
void PolygonTool::describe(const DragResult& result) {
    m_session.describe(withValue(m_session.text(), m_drag, result),
                       qHashMulti(0, int(m_part.kind), m_part.index, m_part.map));
}

// The pivot is no part of the document. It is always drawn to the vertices: turning about one is common.
void PolygonTool::movePivot(const Pointer& pointer) {
    SnapTargets targets = m_scene.snapTargets({}, {});
    targets.snapping |= SnapTo::Vertices;
    const Snapped snap = snapped(
        targets, m_pivotAtPress + worldOffset(m_scene.camera(), pointer.position - m_session.pressedAt()));
    handles().setPivot(snap.point);
    m_scene.marks().showSnap(snap);
}

// Selects at once, so that the user sees it; a press on the empty canvas selects nothing.
void PolygonTool::selectWithin(const Pointer& pointer) {
    const QRectF band = QRectF(m_session.pressedAt(), pointer.position).normalized();
    std::vector<std::size_t> items = enclosedBy(band);
    if (pointer.modifiers & adding) {
        items.insert(items.end(), m_selectionAtPress.begin(), m_selectionAtPress.end());
        std::ranges::sort(items);
        items.erase(std::unique(items.begin(), items.end()), items.end());
    }
    selectItems(items);
    m_scene.marks().showBand(band);
}

void PolygonTool::selectClicked(std::size_t item, Qt::KeyboardModifiers modifiers) {
    if (!(modifiers & adding)) return selectItems({item});
    std::vector<std::size_t> items = selectedItems().value_or(std::vector<std::size_t>());
    if (std::erase(items, item) == 0) items.push_back(item);
    selectItems(items);
}

void PolygonTool::release(const Pointer& pointer) {
    if (m_state == State::Nudging) return;
    const bool click = m_state == State::Pressed;
    if (m_state == State::Dragging) settle();
    end();
    if (click) clicked(m_part, pointer);
    selection().setHovered(m_scene.partAt(pointer.position, pointer.reach));
    emit cursorChanged();
}

// Undo may have ended the gesture in the middle.
void PolygonTool::settle() {
    if (m_session.finish() == DragSession::Outcome::Abandoned) abandoned();
}

// Leaves nothing of a gesture behind; previews that are not committed go.
void PolygonTool::end() {
    const CanvasScene::Batch batch(m_scene);
    if (m_state == State::Nudging) settle();
    m_session.cancel();
    m_state = State::Idle;
    selection().setPressed({});
    m_scene.holdKnobAt(std::nullopt);
    m_scene.marks().showSnap(std::nullopt);
    m_scene.marks().showBand({});
    m_scene.marks().showReadout({}, {});
    ended();
}

void PolygonTool::leave() {
    if (m_state == State::Idle) hover({});
}

bool PolygonTool::cancel() {
    if (m_state == State::Idle || m_state == State::Cancelled) return false;
    const State state = m_state;
    m_session.cancel();
    if (state == State::Selecting) selectItems(m_selectionAtPress);
    if (state != State::Nudging) restorePivot();
    end();
    if (state != State::Nudging) m_state = State::Cancelled;
    emit cursorChanged();
    return true;
}

void PolygonTool::restorePivot() {
    handles().setPivot(m_ownPivotAtPress ? std::optional(m_pivotAtPress) : std::nullopt);
}

// Handles without a number are explained in the status bar.
void PolygonTool::hover(const CanvasPart& part) {
    const CanvasPart before = selection().hovered();
    if (part == before) return;
    selection().setHovered(part);
    const QString use = useOf(part);
    if (!use.isEmpty() || !useOf(before).isEmpty()) emit message(use);
}

void PolygonTool::stop() {
    cancel();
    m_state = State::Idle;
    selection().setHovered({});
    selection().setFocused({});
}

QCursor PolygonTool::cursor(const Pointer& pointer) const {
    const bool held =
        m_state == State::Pressed || m_state == State::Dragging || m_state == State::MovingPivot;
    if (held) return cursorFor(m_part, Holding::Yes);
    if (m_state == State::Selecting) return cursorFor({}, Holding::No);
    const CanvasPart part = m_scene.partAt(pointer.position, pointer.reach);
    const MapFrame* frame = frameOf(m_scene.frames(), part.map);
    return cursorFor(frame && frame->isLocked ? CanvasPart() : part, Holding::No);
}

bool PolygonTool::walk(int step) {
    if (!handles().cage()) return false;
    if (m_state == State::Nudging) end();
    const std::vector<CanvasPart> parts = handles().parts();
    const auto count = std::ptrdiff_t(parts.size());
    const auto found = std::ranges::find(parts, selection().focused());
    const std::ptrdiff_t from = found != parts.end() ? found - parts.begin() : step > 0 ? -1 : count;
    const std::ptrdiff_t index = from + step;
    const bool isThere = index >= 0 && index < count;
    selection().setFocused(isThere ? parts[std::size_t(index)] : CanvasPart());
    return isThere;
}

bool PolygonTool::isBareKey(const QKeyEvent& event, Qt::Key key) const {
    return event.key() == key && !(event.modifiers() & ~Qt::KeypadModifier) && !isBusy();
}

bool PolygonTool::keyPress(const QKeyEvent& event) {
    const QPointF way = arrowDirection(event.key());
    const CanvasPart part = selection().focused();
    if (way.isNull() || part.kind == Kind::None || !handles().cage()) return false;
    m_session.keepRun(event);
    if (m_state == State::Idle || m_state == State::Nudging) nudge(part, way, event.modifiers());
    return true;
}

// Makes one undo step for as long as the key is held.
void PolygonTool::nudge(const CanvasPart& part, const QPointF& way, Qt::KeyboardModifiers modifiers) {
    if (part.kind == Kind::Pivot) {
        handles().setPivot(handles().pivot() + worldOffset(m_scene.camera(), way * nudgePace(modifiers)));
        emit selection().focusMoved();
        return;
    }
    if (m_state == State::Idle) {
        m_part = part;
        m_ownPivotAtPress = handles().hasOwnPivot();
        m_pivotAtPress = handles().pivot();
        if (!open(part, modeOf(part, Qt::NoModifier), m_scene.positionOf(part))) return;
        m_nudge = {};
        m_session.beginRun();
        m_state = State::Nudging;
        emit dragStarted();
    }
    if (!m_session.isOpen()) return end();
    m_nudge += way * nudgePace(modifiers);
    m_nudge *= show([this](double share) { return nudged(m_nudge * share); });
    emit selection().focusMoved();
}

DragResult PolygonTool::nudged(const QPointF& by) const {
    const double amount = by.x() - by.y(); // increases to the right and upwards
    if (m_drag.mode == PolygonDrag::Mode::Rotate) return rotated(m_drag, -amount * std::numbers::pi / 180);
    if (m_drag.mode == PolygonDrag::Mode::Scale)
        return scaled(m_drag, ifs::Vector<2>::Constant(std::pow(1.01, amount)));
    return moved(m_drag, worldOffset(m_scene.camera(), by));
}

} // namespace view
