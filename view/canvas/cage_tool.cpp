// SPDX-License-Identifier: MIT
#include "canvas/cage_tool.h"

#include "cage_edits.h"

#include "canvas/canvas_cursors.h"
#include "canvas/canvas_geometry.h"
#include "document/fractal.h"

#include <QKeyEvent>
#include <QLineF>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace view {

namespace {

using Kind = CanvasPart::Kind;

constexpr double slack = 2; // pixels a click may shake without becoming a drag

CageDrag::Mode modeOf(const CanvasPart& part, Qt::KeyboardModifiers modifiers) {
    if (part.kind == Kind::Rotate) return CageDrag::Mode::Rotate;
    if (part.kind == Kind::Scale) return CageDrag::Mode::Scale;
    if (modifiers.testFlag(Qt::ControlModifier)) return CageDrag::Mode::Rotate;
    return modifiers.testFlag(Qt::AltModifier) ? CageDrag::Mode::Scale : CageDrag::Mode::Move;
}

std::vector<int> verticesOf(const CanvasPart& part, CageDrag::Mode mode, std::size_t count) {
    if (mode == CageDrag::Mode::Move && part.kind == Kind::Vertex) return {part.index};
    if (mode == CageDrag::Mode::Move && part.kind == Kind::Edge)
        return {part.index, int((std::size_t(part.index) + 1) % count)};
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

int nearestVertex(const CageDrag& drag) {
    return *std::ranges::min_element(drag.vertices, {}, [&](int vertex) {
        return (drag.cage.current[std::size_t(vertex)] - drag.press).squaredNorm();
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

CageTool::CageTool(CanvasScene* scene) : CanvasTool(scene), m_scene(scene) {
    m_letGo.setSingleShot(true);
    m_letGo.setInterval(40);
    connect(&m_letGo, &QTimer::timeout, this, &CageTool::end);
}

CageTool::~CageTool() = default;

void CageTool::press(const Pointer& pointer) {
    end();
    m_part = m_scene->partAt(pointer.position, pointer.reach);
    m_scene->setFocused(m_part);
    const bool transforms = pointer.modifiers & (Qt::ControlModifier | Qt::AltModifier);
    if (!m_scene->cage() || !m_scene->overlaysVisible() || (m_part.kind == Kind::None && !transforms)) return;
    m_state = State::Pressed;
    m_press = pointer.position;
    m_camera = m_scene->camera();
    m_pivotAtPress = m_scene->pivot();
    m_ownPivotAtPress = m_scene->hasOwnPivot();
    m_drag = {};
    m_drag.mode = modeOf(m_part, pointer.modifiers);
    m_scene->setPressed(m_part);
    emit cursorChanged();
}

void CageTool::move(const Pointer& pointer) {
    switch (m_state) {
    case State::Idle:
    case State::Nudging:
        hover(m_scene->partAt(pointer.position, pointer.reach));
        return;
    case State::Cancelled:
        return;
    case State::Pressed:
        if ((pointer.position - m_press).manhattanLength() <= slack) return;
        if (m_part.kind == Kind::Pivot && m_drag.mode == CageDrag::Mode::Move) {
            m_state = State::MovingPivot;
        } else {
            open(m_part, m_drag.mode, m_press);
            m_state = State::Dragging;
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

void CageTool::open(const CanvasPart& part, CageDrag::Mode mode, const QPointF& press) {
    m_drag.mode = mode;
    m_drag.cage = *m_scene->cage();
    m_drag.vertices = verticesOf(part, mode, m_drag.cage.current.size());
    m_drag.pivot = m_scene->pivot();
    m_drag.press = worldAt(m_scene->camera(), press);
    m_drag.snapVertex = nearestVertex(m_drag);
    QString text = tr("Move the cage");
    if (mode == CageDrag::Mode::Rotate)
        text = tr("Rotate the cage");
    else if (mode == CageDrag::Mode::Scale)
        text = tr("Scale the cage");
    else if (part.kind == Kind::Vertex)
        text = tr("Move vertex %1").arg(part.index + 1);
    else if (part.kind == Kind::Edge)
        text = tr("Move edge %1–%2").arg(m_drag.vertices[0] + 1).arg(m_drag.vertices[1] + 1);
    m_gesture = std::make_unique<document::EditGesture>(m_scene->document(), text);
}

// Ctrl and Alt may be pressed after the button: some window managers keep a press that comes with one of them
// for themselves. Letting go of the key changes nothing.
void CageTool::turnInto(CageDrag::Mode mode) {
    if (mode == CageDrag::Mode::Move || mode == m_drag.mode || !m_gesture || !m_gesture->isOpen()) return;
    m_gesture.reset();
    restorePivot();
    const ifs::Vector<2> press = m_drag.press;
    open(m_part, mode, m_press);
    m_drag.press = press; // whatever the view has become since
}

void CageTool::dragTo(const Pointer& pointer) {
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
    preview(dragged(m_drag, offset, constraintOf(pointer.modifiers), m_scene->snapTargets(m_drag.vertices)));
}

void CageTool::preview(const DragResult& result) {
    document::Fractal fractal = m_gesture->before();
    if (result.cage != m_drag.cage)
        fractal = withCageMoved(std::move(fractal), result.cage, m_scene->document().cageMode());
    const bool whole = m_drag.vertices.size() == m_drag.cage.current.size();
    if (m_ownPivotAtPress && whole && m_drag.mode == CageDrag::Mode::Move)
        m_scene->setPivot(m_pivotAtPress + result.cage.current.front() - m_drag.cage.current.front());
    m_scene->showSnap(result.snap);
    m_gesture->preview(std::move(fractal));
}

// The pivot is no part of the document. It is always drawn to the vertices: turning about one is common.
void CageTool::movePivot(const Pointer& pointer) {
    SnapTargets targets = m_scene->snapTargets();
    targets.snapping |= SnapTo::Vertices;
    const Snapped snap =
        snapped(targets, m_pivotAtPress + worldOffset(m_scene->camera(), pointer.position - m_press));
    m_scene->setPivot(snap.point);
    m_scene->showSnap(snap);
}

void CageTool::release(const Pointer& pointer) {
    if (m_state == State::Nudging) return;
    if (m_state == State::Dragging && m_gesture) m_gesture->commit();
    end();
    m_scene->setHovered(m_scene->partAt(pointer.position, pointer.reach));
    emit cursorChanged();
}

// Leaves nothing of a gesture behind; what has been previewed and not committed goes.
void CageTool::end() {
    if (m_state == State::Nudging && m_gesture) m_gesture->commit();
    m_gesture.reset();
    m_letGo.stop();
    m_state = State::Idle;
    m_scene->setPressed({});
    m_scene->holdKnobAt(std::nullopt);
    m_scene->showSnap(std::nullopt);
}

void CageTool::leave() {
    if (m_state == State::Idle) hover({});
}

bool CageTool::cancel() {
    if (m_state == State::Idle || m_state == State::Cancelled) return false;
    const State state = m_state;
    if (m_gesture) m_gesture->cancel();
    if (state != State::Nudging) restorePivot();
    end();
    if (state != State::Nudging) m_state = State::Cancelled;
    emit cursorChanged();
    return true;
}

void CageTool::restorePivot() {
    m_scene->setPivot(m_ownPivotAtPress ? std::optional(m_pivotAtPress) : std::nullopt);
}

// What the handles without a number are for is said in the status bar.
void CageTool::hover(const CanvasPart& part) {
    const CanvasPart before = m_scene->hovered();
    if (part == before) return;
    m_scene->setHovered(part);
    const QString use = m_scene->useOf(part);
    if (!use.isEmpty() || !m_scene->useOf(before).isEmpty()) emit message(use);
}

void CageTool::stop() {
    cancel();
    m_state = State::Idle;
    m_scene->setHovered({});
    m_scene->setFocused({});
}

QCursor CageTool::cursor(const Pointer& pointer) const {
    const bool held =
        m_state == State::Pressed || m_state == State::Dragging || m_state == State::MovingPivot;
    if (held) return cursorFor(m_part, Holding::Yes);
    return cursorFor(m_scene->partAt(pointer.position, pointer.reach), Holding::No);
}

void CageTool::walk(int step) {
    if (!m_scene->cage()) return;
    if (m_state == State::Nudging) end();
    const std::vector<CanvasPart> parts = m_scene->handles();
    const auto count = std::ptrdiff_t(parts.size());
    const auto found = std::ranges::find(parts, m_scene->focused());
    std::ptrdiff_t place = step > 0 ? -1 : count;
    if (found != parts.end()) place = found - parts.begin();
    m_scene->setFocused(parts[std::size_t((place + step + count) % count)]);
}

bool CageTool::keyPress(const QKeyEvent& event) {
    const QPointF way = direction(event.key());
    const CanvasPart part = m_scene->focused();
    if (way.isNull() || part.kind == Kind::None || !m_scene->cage()) return false;
    keepNudging(event.timestamp());
    if (m_state == State::Idle || m_state == State::Nudging) nudge(part, way, event.modifiers());
    return true;
}

bool CageTool::keyRelease(const QKeyEvent& event) {
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
void CageTool::keepNudging(quint64 stamp) {
    if (!m_letGo.isActive()) return;
    m_letGo.stop();
    if (stamp != m_letGoStamp) end();
}

// One undo step for as long as the key is held.
void CageTool::nudge(const CanvasPart& part, const QPointF& way, Qt::KeyboardModifiers modifiers) {
    if (part.kind == Kind::Pivot) {
        m_scene->setPivot(m_scene->pivot() + worldOffset(m_scene->camera(), way * pace(modifiers)));
        emit m_scene->focusMoved();
        return;
    }
    if (m_state == State::Idle) {
        m_drag = {};
        m_ownPivotAtPress = m_scene->hasOwnPivot();
        m_pivotAtPress = m_scene->pivot();
        open(part, modeOf(part, Qt::NoModifier), m_scene->positionOf(part));
        m_nudge = {};
        m_state = State::Nudging;
        emit grasped();
    }
    if (!m_gesture->isOpen()) {
        end();
        return;
    }
    m_nudge += way * pace(modifiers);
    const ifs::ControlCage<2> cage = nudged(part);
    preview({cage, {cage.current.front()}});
    emit m_scene->focusMoved();
}

ifs::ControlCage<2> CageTool::nudged(const CanvasPart& part) const {
    const double amount = m_nudge.x() - m_nudge.y(); // right and up are more
    if (part.kind == Kind::Rotate)
        return rotated(m_drag.cage, m_drag.pivot, -amount * std::numbers::pi / 180);
    if (part.kind == Kind::Scale)
        return scaled(m_drag.cage, m_drag.pivot, ifs::Vector<2>::Constant(std::pow(1.01, amount)));
    ifs::ControlCage<2> cage = m_drag.cage;
    const ifs::Vector<2> offset = worldOffset(m_scene->camera(), m_nudge);
    for (const int vertex : m_drag.vertices)
        cage.current[std::size_t(vertex)] += offset;
    return cage;
}

} // namespace view
