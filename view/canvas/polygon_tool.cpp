// SPDX-License-Identifier: MIT
#include "canvas/polygon_tool.h"

#include "canvas/canvas_cursors.h"
#include "canvas/canvas_geometry.h"

#include <QKeyEvent>
#include <QLineF>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace view {

namespace {

using Kind = CanvasPart::Kind;

constexpr double slack = 2; // pixels a click may shake without becoming a drag

PolygonDrag::Mode modeOf(const CanvasPart& part, Qt::KeyboardModifiers modifiers) {
    if (part.kind == Kind::Rotate) return PolygonDrag::Mode::Rotate;
    if (part.kind == Kind::Scale) return PolygonDrag::Mode::Scale;
    if (modifiers.testFlag(Qt::ControlModifier)) return PolygonDrag::Mode::Rotate;
    return modifiers.testFlag(Qt::AltModifier) ? PolygonDrag::Mode::Scale : PolygonDrag::Mode::Move;
}

int nearestVertex(const PolygonDrag& drag) {
    return *std::ranges::min_element(drag.vertices, {}, [&](int vertex) {
        return (drag.points[std::size_t(vertex)] - drag.press).squaredNorm();
    });
}

QPointF direction(int key) {
    switch (key) {
    case Qt::Key_Left:
        return {-1, 0};
    case Qt::Key_Right:
        return {1, 0};
    case Qt::Key_Up:
        return {0, -1};
    case Qt::Key_Down:
        return {0, 1};
    default:
        return {};
    }
}

double pace(Qt::KeyboardModifiers modifiers) {
    if (modifiers.testFlag(Qt::ShiftModifier)) return 10;
    return modifiers.testFlag(Qt::AltModifier) ? 0.1 : 1;
}

Constraint constraintOf(Qt::KeyboardModifiers modifiers) {
    return modifiers.testFlag(Qt::ShiftModifier) ? Constraint::Constrained : Constraint::Free;
}

} // namespace

PolygonTool::PolygonTool(CanvasScene* scene) : CanvasTool(scene), m_scene(scene) {
    m_letGo.setSingleShot(true);
    m_letGo.setInterval(40);
    connect(&m_letGo, &QTimer::timeout, this, &PolygonTool::end);
}

PolygonTool::~PolygonTool() = default;

void PolygonTool::press(const Pointer& pointer) {
    end();
    m_part = m_scene->partAt(pointer.position, pointer.reach);
    m_scene->setFocused(m_part);
    if (!m_scene->cage() || !m_scene->overlaysVisible()) return;
    m_press = pointer.position;
    m_camera = m_scene->camera();
    m_pivotAtPress = m_scene->pivot();
    m_ownPivotAtPress = m_scene->hasOwnPivot();
    const bool transforms = pointer.modifiers & (Qt::ControlModifier | Qt::AltModifier);
    if (m_part.kind == Kind::None && !transforms) {
        const std::optional<std::vector<std::size_t>> selection = this->selection();
        if (!selection) return;
        m_selectionAtPress = *selection;
        m_state = State::Selecting;
        selectWithin(pointer);
        return;
    }
    m_state = State::Pressed;
    m_drag = {};
    m_drag.mode = modeOf(m_part, pointer.modifiers);
    m_scene->setPressed(m_part);
    taken(m_part, pointer.modifiers);
    emit cursorChanged();
}

void PolygonTool::move(const Pointer& pointer) {
    switch (m_state) {
    case State::Idle:
    case State::Nudging:
        hover(m_scene->partAt(pointer.position, pointer.reach));
        return;
    case State::Cancelled:
        return;
    case State::Selecting:
        selectWithin(pointer);
        return;
    case State::Pressed:
        if ((pointer.position - m_press).manhattanLength() <= slack) return;
        if (m_part.kind == Kind::Pivot && m_drag.mode == PolygonDrag::Mode::Move) {
            m_state = State::MovingPivot;
        } else if (open(m_part, m_drag.mode, m_press)) {
            m_state = State::Dragging;
        } else {
            end();
            m_state = State::Cancelled;
            return;
        }
        emit grasped();
        break;
    case State::Dragging:
        turnInto(modeOf(m_part, pointer.modifiers));
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
    std::optional<Grip> grip = this->grip(part, mode);
    if (!grip) return false;
    m_drag = {mode, std::move(grip->points), std::move(grip->vertices)};
    m_drag.pivot = m_scene->pivot();
    m_drag.press = worldAt(m_scene->camera(), press);
    m_drag.snapVertex = nearestVertex(m_drag);
    m_gesture = std::make_unique<document::EditGesture>(m_scene->document(), grip->text);
    return true;
}

// Ctrl and Alt may be pressed after the button: some window managers keep a press that comes with one of them
// for themselves. Letting go of the key changes nothing.
void PolygonTool::turnInto(PolygonDrag::Mode mode) {
    if (mode == PolygonDrag::Mode::Move || mode == m_drag.mode || !m_gesture || !m_gesture->isOpen()) return;
    m_gesture.reset();
    restorePivot();
    const ifs::Vector<2> press = m_drag.press;
    if (open(m_part, mode, m_press)) m_drag.press = press; // whatever the view has become since
}

void PolygonTool::dragTo(const Pointer& pointer) {
    if (!m_gesture || !m_gesture->isOpen()) { // the document has moved on without us
        end();
        m_state = State::Cancelled;
        return;
    }
    // Zooming in the middle of a drag changes what a pixel means: then the plane is the reference.
    const ifs::Vector<2> offset =
        m_camera == m_scene->camera()
            ? worldOffset(m_camera, pointer.position - m_press)
            : ifs::Vector<2>(worldAt(m_scene->camera(), pointer.position) - m_drag.press);
    if (m_part.kind == Kind::Rotate || m_part.kind == Kind::Scale) m_scene->holdKnobAt(pointer.position);
    const Constraint constraint = constraintOf(pointer.modifiers);
    SnapTargets targets = m_scene->snapTargets(m_part, m_drag.vertices);
    const Snapping snapping = targets.snapping;
    show([&](double share) {
        targets.snapping = share < 1 ? Snapping() : snapping; // on the way nothing is drawn aside
        return dragged(m_drag, offset * share, constraint, targets);
    });
}

double PolygonTool::show(const std::function<DragResult(double)>& resultAt) {
    const double share = preview(resultAt);
    const DragResult result = resultAt(share);
    const bool whole = m_drag.vertices.size() == m_drag.points.size();
    if (m_ownPivotAtPress && whole && m_drag.mode == PolygonDrag::Mode::Move)
        m_scene->setPivot(m_pivotAtPress + result.change.translation);
    m_scene->showSnap(result.snap);
    return share;
}

// The pivot is no part of the document. It is always drawn to the vertices: turning about one is common.
void PolygonTool::movePivot(const Pointer& pointer) {
    SnapTargets targets = m_scene->snapTargets({}, {});
    targets.snapping |= SnapTo::Vertices;
    const Snapped snap =
        snapped(targets, m_pivotAtPress + worldOffset(m_scene->camera(), pointer.position - m_press));
    m_scene->setPivot(snap.point);
    m_scene->showSnap(snap);
}

// At once, so that one sees it; a press on the empty canvas selects nothing.
void PolygonTool::selectWithin(const Pointer& pointer) {
    const QRectF band = QRectF(m_press, pointer.position).normalized();
    std::vector<std::size_t> items = enclosedBy(band);
    if (pointer.modifiers & adding) {
        items.insert(items.end(), m_selectionAtPress.begin(), m_selectionAtPress.end());
        std::ranges::sort(items);
        items.erase(std::unique(items.begin(), items.end()), items.end());
    }
    setSelection(items);
    m_scene->showBand(band);
}

void PolygonTool::selectClicked(std::size_t item, Qt::KeyboardModifiers modifiers) {
    if (!(modifiers & adding)) return setSelection({item});
    std::vector<std::size_t> items = selection().value_or(std::vector<std::size_t>());
    if (std::erase(items, item) == 0) items.push_back(item);
    setSelection(items);
}

void PolygonTool::release(const Pointer& pointer) {
    if (m_state == State::Nudging) return;
    const bool click = m_state == State::Pressed;
    if (m_state == State::Dragging && m_gesture) m_gesture->commit();
    end();
    if (click) clicked(m_part, pointer);
    m_scene->setHovered(m_scene->partAt(pointer.position, pointer.reach));
    emit cursorChanged();
}

// Leaves nothing of a gesture behind; what has been previewed and not committed goes.
void PolygonTool::end() {
    if (m_state == State::Nudging && m_gesture) m_gesture->commit();
    m_gesture.reset();
    m_letGo.stop();
    m_state = State::Idle;
    m_scene->setPressed({});
    m_scene->holdKnobAt(std::nullopt);
    m_scene->showSnap(std::nullopt);
    m_scene->showBand({});
    ended();
}

void PolygonTool::leave() {
    if (m_state == State::Idle) hover({});
}

bool PolygonTool::cancel() {
    if (m_state == State::Idle || m_state == State::Cancelled) return false;
    const State state = m_state;
    if (m_gesture) m_gesture->cancel();
    if (state == State::Selecting) setSelection(m_selectionAtPress);
    if (state != State::Nudging) restorePivot();
    end();
    if (state != State::Nudging) m_state = State::Cancelled;
    emit cursorChanged();
    return true;
}

void PolygonTool::restorePivot() {
    m_scene->setPivot(m_ownPivotAtPress ? std::optional(m_pivotAtPress) : std::nullopt);
}

// What the handles without a number are for is said in the status bar.
void PolygonTool::hover(const CanvasPart& part) {
    const CanvasPart before = m_scene->hovered();
    if (part == before) return;
    m_scene->setHovered(part);
    const QString use = m_scene->useOf(part);
    if (!use.isEmpty() || !m_scene->useOf(before).isEmpty()) emit message(use);
}

void PolygonTool::stop() {
    cancel();
    m_state = State::Idle;
    m_scene->setHovered({});
    m_scene->setFocused({});
}

QCursor PolygonTool::cursor(const Pointer& pointer) const {
    const bool held =
        m_state == State::Pressed || m_state == State::Dragging || m_state == State::MovingPivot;
    if (held) return cursorFor(m_part, Holding::Yes);
    if (m_state == State::Selecting) return cursorFor({}, Holding::No);
    return cursorFor(m_scene->partAt(pointer.position, pointer.reach), Holding::No);
}

void PolygonTool::walk(int step) {
    if (!m_scene->cage()) return;
    if (m_state == State::Nudging) end();
    const std::vector<CanvasPart> parts = m_scene->handles();
    const auto count = std::ptrdiff_t(parts.size());
    const auto found = std::ranges::find(parts, m_scene->focused());
    std::ptrdiff_t place = step > 0 ? -1 : count;
    if (found != parts.end()) place = found - parts.begin();
    m_scene->setFocused(parts[std::size_t((place + step + count) % count)]);
}

bool PolygonTool::isBareKey(const QKeyEvent& event, Qt::Key key) const {
    return event.key() == key && !(event.modifiers() & ~Qt::KeypadModifier) && !isBusy();
}

bool PolygonTool::keyPress(const QKeyEvent& event) {
    const QPointF way = direction(event.key());
    const CanvasPart part = m_scene->focused();
    if (way.isNull() || part.kind == Kind::None || !m_scene->cage()) return false;
    keepNudging(event.timestamp());
    if (m_state == State::Idle || m_state == State::Nudging) nudge(part, way, event.modifiers());
    return true;
}

bool PolygonTool::keyRelease(const QKeyEvent& event) {
    if (direction(event.key()).isNull() || m_state != State::Nudging) return false;
    if (event.isAutoRepeat()) return true;
    m_letGoStamp = event.timestamp();
    if (m_letGoStamp == 0)
        end();
    else
        m_letGo.start();
    return true;
}

// An X server reports a key that repeats as going up and down at the same time, and Qt sees through that only
// when both reports have arrived.
void PolygonTool::keepNudging(quint64 stamp) {
    if (!m_letGo.isActive()) return;
    m_letGo.stop();
    if (stamp != m_letGoStamp) end();
}

// One undo step for as long as the key is held.
void PolygonTool::nudge(const CanvasPart& part, const QPointF& way, Qt::KeyboardModifiers modifiers) {
    if (part.kind == Kind::Pivot) {
        m_scene->setPivot(m_scene->pivot() + worldOffset(m_scene->camera(), way * pace(modifiers)));
        emit m_scene->focusMoved();
        return;
    }
    if (m_state == State::Idle) {
        m_part = part;
        m_ownPivotAtPress = m_scene->hasOwnPivot();
        m_pivotAtPress = m_scene->pivot();
        if (!open(part, modeOf(part, Qt::NoModifier), m_scene->positionOf(part))) return;
        m_nudge = {};
        m_state = State::Nudging;
        emit grasped();
    }
    if (!m_gesture->isOpen()) {
        end();
        return;
    }
    m_nudge += way * pace(modifiers);
    m_nudge *= show([this](double share) { return nudged(m_nudge * share); });
    emit m_scene->focusMoved();
}

DragResult PolygonTool::nudged(const QPointF& by) const {
    const double amount = by.x() - by.y(); // right and up are more
    if (m_drag.mode == PolygonDrag::Mode::Rotate) return rotated(m_drag, -amount * std::numbers::pi / 180);
    if (m_drag.mode == PolygonDrag::Mode::Scale)
        return scaled(m_drag, ifs::Vector<2>::Constant(std::pow(1.01, amount)));
    return moved(m_drag, worldOffset(m_scene->camera(), by));
}

} // namespace view
