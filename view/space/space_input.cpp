// SPDX-License-Identifier: MIT
#include "space/space_input.h"

#include "attractor/request/orbit_navigation.h"
#include "canvas/geometry/canvas_geometry.h"
#include "document/edits/space_cage_edits.h"
#include "document/space_geometry.h"
#include "widgets/arrow_keys.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double degreesPerKey = 5;
constexpr double clickReach = 4;  // pixels that a click may move
constexpr double shiftReach = 6;  // pixels of motion by which Shift chooses an axis
constexpr double pushPixels = 20; // by one notch of the wheel

// X, Y or Z of a drag; with Ctrl they are shortcuts of the window.
bool isAxisKey(const QKeyEvent& event) {
    const bool isShortcut = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    return !isShortcut && event.key() >= Qt::Key_X && event.key() <= Qt::Key_Z;
}

bool isOnKeypad(const QKeyEvent& event) {
    return event.modifiers().testFlag(Qt::KeypadModifier);
}

double notches(const QWheelEvent& event) {
    return event.angleDelta().y() / 120.0;
}

} // namespace

SpaceInput::SpaceInput(document::Document* document, SpaceNavigation& navigation, SpaceCageItem& cage,
                       SliceItem& slice, AxisBall& ball)
    : m_document(document), m_navigation(navigation), m_cage(cage), m_slice(slice), m_ball(ball) {}

void SpaceInput::press(const QMouseEvent& event) {
    if (!isIdle()) {
        cancelGesture();
        return;
    }
    m_pointer = event.position();
    const bool pans =
        event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && m_isSpaceHeld);
    const auto handles = m_isEnabled ? m_cage.handlesAt(m_pointer) : std::vector<std::size_t>();
    if (pans) {
        m_gesture.emplace<Panning>(Panning{m_navigation.camera(), m_pointer});
    } else if (event.button() == Qt::RightButton) {
        beginOrbit(event, std::nullopt);
    } else if (event.button() == Qt::LeftButton && m_isEnabled && m_ball.covers(m_pointer)) {
        beginOrbit(event, m_ball.endAt(m_pointer));
    } else if (event.button() == Qt::LeftButton && !handles.empty()) {
        // Of two, the one that Tab has chosen.
        const bool isChosen = m_focused && std::ranges::find(handles, *m_focused) != handles.end();
        beginDrag(isChosen ? *m_focused : handles.front(), event);
    } else if (event.button() == Qt::LeftButton && isOnSlice(m_pointer)) {
        m_gesture.emplace<Slicing>(Slicing{m_document->beginGesture(tr("Move the Slice")),
                                           m_navigation.camera(), *m_slice.plane(), toVector(m_pointer)});
    } else if (event.button() == Qt::LeftButton) {
        beginOrbit(event, std::nullopt);
    }
    emit changed();
}

void SpaceInput::beginOrbit(const QMouseEvent& event, std::optional<AxisBall::End> end) {
    Orbiting orbiting;
    orbiting.before = m_navigation.camera();
    const bool onBall = m_isEnabled && m_ball.covers(event.position());
    const auto point = onBall ? std::nullopt : m_navigation.pointUnder(event.position());
    orbiting.pivot = point.value_or(m_navigation.camera().target);
    orbiting.press = event.position();
    orbiting.end = end;
    orbiting.button = event.button();
    m_gesture.emplace<Orbiting>(orbiting);
}

void SpaceInput::beginDrag(std::size_t vertex, const QMouseEvent& event) {
    const auto cage = document::spaceCage(m_document->fractal());
    if (!cage || vertex >= cage->current.size()) return;
    SpatialDrag drag;
    drag.camera = m_navigation.camera();
    drag.vertices = cage->current;
    drag.held = vertex;
    drag.press = toVector(event.position());
    if (event.modifiers().testFlag(Qt::ControlModifier)) drag.mode = SpatialDrag::Mode::Rotate;
    if (event.modifiers().testFlag(Qt::AltModifier)) drag.mode = SpatialDrag::Mode::Scale;
    const QString text = drag.mode == SpatialDrag::Mode::Rotate  ? tr("Rotate Cage")
                         : drag.mode == SpatialDrag::Mode::Scale ? tr("Scale Cage")
                                                                 : tr("Move Vertex %1").arg(vertex + 1);
    const Pull pull{drag.press, 0};
    m_focused = vertex;
    m_gesture.emplace<Dragging>(Dragging{m_document->beginGesture(text), std::move(drag), pull, {}, false});
}

void SpaceInput::move(const QMouseEvent& event) {
    m_pointer = event.position();
    if (auto* orbiting = std::get_if<Orbiting>(&m_gesture)) {
        follow(*orbiting, m_pointer);
    } else if (auto* panning = std::get_if<Panning>(&m_gesture)) {
        m_navigation.moveTo(attractor::panned(panning->before, toVector(m_pointer - panning->press)), true);
    } else if (auto* dragging = std::get_if<Dragging>(&m_gesture)) {
        follow(*dragging, event);
    } else if (auto* slicing = std::get_if<Slicing>(&m_gesture)) {
        follow(*slicing, m_pointer);
    } else {
        const auto handles = m_isEnabled ? m_cage.handlesAt(m_pointer) : std::vector<std::size_t>();
        m_hovered = handles.empty() ? std::nullopt : std::optional(handles.front());
        report(m_pointer);
    }
    emit changed();
}

void SpaceInput::follow(Orbiting& orbiting, const QPointF& position) {
    const QPointF delta = position - orbiting.press;
    if (!orbiting.hasMoved && std::hypot(delta.x(), delta.y()) < clickReach) return;
    if (!orbiting.hasMoved) {
        m_navigation.leaveAxisView();
        orbiting.before = m_navigation.camera();
        orbiting.hasMoved = true;
    }
    m_navigation.moveTo(attractor::orbited(orbiting.before, orbiting.pivot, -degreesPerPixel * delta.x(),
                                           degreesPerPixel * delta.y()),
                        true);
}

bool SpaceInput::isOnSlice(const QPointF& position) const {
    return m_isEnabled && m_slice.isHandleAt(position);
}

void SpaceInput::follow(Slicing& slicing, const QPointF& position) {
    document::Fractal moved = slicing.gesture.before();
    if (!moved.inSpace.clip) return;
    moved.inSpace.clip = slid(*moved.inSpace.clip,
                              slideBetween(slicing.camera, slicing.plane, slicing.press, toVector(position)));
    if (isUsable(*moved.inSpace.clip)) slicing.gesture.preview(moved);
}

void SpaceInput::follow(Dragging& dragging, const QMouseEvent& event) {
    dragging.pull.pointer = toVector(event.position());
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    const ifs::Vector<2> motion = dragging.pull.pointer - dragging.drag.press;
    if (shift && !dragging.isLockedByShift && dragging.lock.kind == AxisLock::Kind::View &&
        motion.norm() >= shiftReach) {
        const auto& vertex = dragging.drag.vertices[dragging.drag.held];
        if (const auto axis = nearestAxis(dragging.drag.camera, vertex, motion)) {
            dragging.lock = {AxisLock::Kind::Axis, *axis};
            dragging.isLockedByShift = true;
        }
    } else if (!shift && dragging.isLockedByShift) {
        dragging.lock = {};
        dragging.isLockedByShift = false;
    }
    preview(dragging);
}

void SpaceInput::preview(Dragging& dragging) {
    const document::Fractal& before = dragging.gesture.before();
    auto cage = document::spaceCage(before);
    if (!cage) return;
    cage->current = dragged(dragging.drag, dragging.pull, dragging.lock);
    if (cage->current == dragging.drag.vertices)
        dragging.gesture.preview(before); // where it began, to the bit
    else
        dragging.gesture.preview(
            document::withSpaceCageMoved(before, *std::move(cage), m_document->cageMode()));
    report(dragging);
}

void SpaceInput::release(const QMouseEvent& event) {
    if (auto* dragging = std::get_if<Dragging>(&m_gesture)) {
        if (event.button() != Qt::LeftButton) return;
        dragging->gesture.commit();
    } else if (auto* slicing = std::get_if<Slicing>(&m_gesture)) {
        if (event.button() != Qt::LeftButton) return;
        slicing->gesture.commit();
    } else if (const auto* orbiting = std::get_if<Orbiting>(&m_gesture)) {
        if (event.button() != orbiting->button) return;
        const Orbiting done = *orbiting;
        m_gesture.emplace<std::monostate>();
        if (done.hasMoved) {
            m_navigation.moveTo(m_navigation.camera());
        } else if (done.end) {
            const bool isThere = AxisBall::looksFrom(m_navigation.camera(), *done.end);
            m_navigation.lookFrom(
                AxisBall::towards({done.end->axis, isThere ? !done.end->isPositive : done.end->isPositive}));
        } else if (done.button == Qt::RightButton) {
            emit menuRequested(event.globalPosition().toPoint());
        }
    }
    m_gesture.emplace<std::monostate>();
    move(event);
}

void SpaceInput::handleDoubleClick(const QMouseEvent& event) {
    const bool onHandle = m_isEnabled && !m_cage.handlesAt(event.position()).empty();
    const auto point = m_navigation.pointUnder(event.position());
    if (event.button() == Qt::LeftButton && point && !onHandle)
        m_navigation.glideTo(attractor::centredOn(m_navigation.camera(), *point));
    else
        press(event);
}

void SpaceInput::wheel(const QWheelEvent& event) {
    if (auto* dragging = std::get_if<Dragging>(&m_gesture)) {
        dragging->pull.away += notches(event) * pushPixels / pixelsPerUnit(dragging->drag.camera);
        preview(*dragging);
        return;
    }
    if (isIdle()) m_navigation.zoomAt(event.position(), std::pow(1.0015, event.angleDelta().y()));
}

void SpaceInput::leave() {
    m_hovered.reset();
    m_pointer = {-1, -1};
    emit pointerLeft();
    emit changed();
}

bool SpaceInput::needsKey(const QKeyEvent& event) const {
    if (!isIdle()) return isAxisKey(event) || event.key() == Qt::Key_Escape;
    return event.key() == Qt::Key_Space || !arrowDirection(event.key()).isNull() ||
           (isOnKeypad(event) && event.key() >= Qt::Key_0 && event.key() <= Qt::Key_9);
}

bool SpaceInput::keyPress(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape) return cancelGesture();
    if (lockBy(event) || viewBy(event)) return true;
    if (event.key() == Qt::Key_Space) {
        m_isSpaceHeld = true;
        emit changed();
        return true;
    }
    const QPointF way = arrowDirection(event.key());
    if (way.isNull() || !isIdle()) return false;
    const double factor = event.modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1;
    if (m_focused) {
        nudge(factor * way);
    } else {
        const attractor::OrbitCamera& camera = m_navigation.camera();
        m_navigation.moveTo(
            attractor::orbited(camera, camera.target, degreesPerKey * way.x(), -degreesPerKey * way.y()));
    }
    return true;
}

void SpaceInput::keyRelease(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Space || event.isAutoRepeat()) return;
    m_isSpaceHeld = false;
    emit changed();
}

bool SpaceInput::lockBy(const QKeyEvent& event) {
    auto* dragging = std::get_if<Dragging>(&m_gesture);
    if (!dragging || !isAxisKey(event)) return false;
    const AxisLock wanted{event.modifiers().testFlag(Qt::ShiftModifier) ? AxisLock::Kind::Plane
                                                                        : AxisLock::Kind::Axis,
                          event.key() - Qt::Key_X};
    dragging->lock = dragging->lock == wanted ? AxisLock{} : wanted;
    dragging->isLockedByShift = false;
    preview(*dragging);
    return true;
}

// The keypad's views, as in modelling programs; with Ctrl from the opposite side.
bool SpaceInput::viewBy(const QKeyEvent& event) {
    if (!isIdle()) return false;
    const bool isOpposite = event.modifiers().testFlag(Qt::ControlModifier);
    if (event.key() == Qt::Key_Home) {
        m_navigation.lookFrom(AxisBall::isometric);
        return true;
    }
    if (!isOnKeypad(event)) return false;
    switch (event.key()) {
    case Qt::Key_1:
        m_navigation.lookFrom(AxisBall::towards({2, !isOpposite}));
        return true;
    case Qt::Key_3:
        m_navigation.lookFrom(AxisBall::towards({0, !isOpposite}));
        return true;
    case Qt::Key_7:
        m_navigation.lookFrom(AxisBall::towards({1, !isOpposite}));
        return true;
    case Qt::Key_5:
        m_navigation.setPerspective(!m_navigation.isPerspective());
        return true;
    default:
        return false;
    }
}

void SpaceInput::nudge(const QPointF& pixels) {
    auto cage = document::spaceCage(m_document->fractal());
    if (!cage || *m_focused >= cage->current.size()) return;
    SpatialDrag drag;
    drag.camera = m_navigation.camera();
    drag.vertices = cage->current;
    drag.held = *m_focused;
    cage->current = dragged(drag, {toVector(pixels), 0}, {});
    m_document->edit(
        tr("Move Vertex %1").arg(*m_focused + 1),
        document::withSpaceCageMoved(m_document->fractal(), *std::move(cage), m_document->cageMode()));
}

bool SpaceInput::cancelGesture() {
    if (isIdle()) return false;
    if (auto* orbiting = std::get_if<Orbiting>(&m_gesture)) m_navigation.moveTo(orbiting->before);
    if (auto* panning = std::get_if<Panning>(&m_gesture)) m_navigation.moveTo(panning->before);
    m_gesture.emplace<std::monostate>(); // an edit is cancelled as it goes
    emit changed();
    return true;
}

bool SpaceInput::focusVertex(bool next) {
    const std::size_t count = m_isEnabled ? m_cage.count() : 0;
    const std::size_t vertex = m_focused ? (next ? *m_focused + 1 : *m_focused - 1) : (next ? 0 : count - 1);
    m_focused = vertex < count ? std::optional(vertex) : std::nullopt;
    emit changed();
    return m_focused.has_value();
}

void SpaceInput::forgetFocus() {
    cancelGesture();
    m_focused.reset();
    m_hovered.reset();
}

void SpaceInput::setEnabled(bool enabled) {
    cancelGesture();
    m_isEnabled = enabled;
}

void SpaceInput::showMarks(bool hasFocus) {
    std::optional<std::size_t> pressed;
    if (const auto* dragging = std::get_if<Dragging>(&m_gesture)) pressed = dragging->drag.held;
    const bool isSlicing = std::holds_alternative<Slicing>(m_gesture);
    m_slice.setHeld(isIdle() && !m_hovered && isOnSlice(m_pointer), isSlicing);
    m_cage.setMarks(m_hovered, pressed, hasFocus ? m_focused : std::nullopt);
    m_ball.setHovered(isIdle() ? m_ball.endAt(m_pointer) : std::nullopt);
}

Qt::CursorShape SpaceInput::cursor() const {
    if (std::holds_alternative<Dragging>(m_gesture) || std::holds_alternative<Panning>(m_gesture) ||
        std::holds_alternative<Slicing>(m_gesture))
        return Qt::ClosedHandCursor;
    if (isIdle() && (m_hovered || m_isSpaceHeld || isOnSlice(m_pointer))) return Qt::OpenHandCursor;
    if (isIdle() && m_isEnabled && m_ball.covers(m_pointer)) return Qt::PointingHandCursor;
    return Qt::CrossCursor;
}

void SpaceInput::report(const QPointF& position) {
    const auto cage = document::space(m_document->fractal());
    if (!cage) return;
    SpacePosition at;
    const attractor::OrbitCamera& camera = m_navigation.camera();
    const auto point = m_navigation.pointUnder(position);
    at.onAttractor = point.has_value();
    at.world = point.value_or(toWorld(camera, {toVector(position), 0}));
    at.depth = toScreen(camera, at.world).depth;
    at.unitsPerPixel = 1 / pixelsPerUnit(camera);
    const auto& vertices = m_cage.vertices();
    ifs::Simplex<3> simplex;
    if (vertices.size() == simplex.size()) {
        std::ranges::copy(vertices, simplex.begin());
        if (ifs::isAffineBasis<3>(simplex)) at.barycentric = ifs::barycentric<3>(simplex, at.world);
    }
    emit pointerMoved(at);
}

// Where the corner is now, and how it may move.
void SpaceInput::report(const Dragging& dragging) {
    const auto cage = document::spaceCage(m_document->fractal());
    if (!cage) return;
    SpacePosition at;
    at.world = cage->current[dragging.drag.held];
    at.unitsPerPixel = 1 / pixelsPerUnit(dragging.drag.camera);
    at.lock = dragging.lock;
    emit pointerMoved(at);
}

} // namespace view
