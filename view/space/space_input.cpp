// SPDX-License-Identifier: MIT
#include "space/space_input.h"

#include "attractor/request/orbit_navigation.h"
#include "canvas/geometry/canvas_geometry.h"
#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/space_cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "space/keypad_views.h"
#include "space/space_symmetry.h"
#include "widgets/arrow_keys.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double degreesPerKey = 5;
constexpr double pixelsPerKey = 20;
constexpr double clickReach = 4;  // pixels that a click may move
constexpr double shiftReach = 6;  // pixels of motion by which Shift chooses an axis
constexpr double knobReach = 11;  // pixels around the handle of a symmetry
constexpr double pushPixels = 20; // by one notch of the wheel

// X, Y or Z of a drag; with Ctrl they are shortcuts of the window.
bool isAxisKey(const QKeyEvent& event) {
    const bool isShortcut = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    return !isShortcut && event.key() >= Qt::Key_X && event.key() <= Qt::Key_Z;
}

double notches(const QWheelEvent& event) {
    return event.angleDelta().y() / 120.0;
}

} // namespace

SpaceInput::SpaceInput(document::Document* document, SpaceNavigation& navigation, const Items& items)
    : m_document(document),
      m_navigation(navigation),
      m_cage(items.cage),
      m_maps(items.maps),
      m_branch(items.branch),
      m_map(items.map),
      m_definition(items.definition),
      m_slice(items.slice),
      m_symmetry(items.symmetry),
      m_ball(items.ball),
      m_ballFocus(m_ball, navigation) {}

void SpaceInput::press(const QMouseEvent& event) {
    if (!isIdle()) {
        cancelGesture();
        return;
    }
    m_pointer = event.position();
    if (!m_ball.covers(m_pointer)) m_ballFocus.leave();
    const bool pans =
        event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && m_isSpaceHeld);
    if (pans) {
        m_gesture.emplace<Panning>(Panning{m_navigation.camera(), m_pointer});
    } else if (event.button() == Qt::RightButton) {
        beginOrbit(event, std::nullopt);
    } else if (event.button() == Qt::LeftButton && m_isEnabled && !m_isFixed && m_ball.covers(m_pointer)) {
        beginOrbit(event, m_ball.endAt(m_pointer));
    } else if (event.button() == Qt::LeftButton && m_isEnabled && m_definition.isActive()) {
        defineAt(m_pointer);
    } else if (event.button() == Qt::LeftButton && m_isEnabled && pressHandle(m_pointer, event)) {
        // it is held now
    } else if (event.button() == Qt::LeftButton && isOnSymmetry(m_pointer)) {
        beginSymmetryDrag();
    } else if (event.button() == Qt::LeftButton && isOnSlice(m_pointer)) {
        m_gesture.emplace<Slicing>(Slicing{m_document->beginGesture(tr("Move the Slice")),
                                           m_navigation.camera(), *m_slice.plane(), toVector(m_pointer)});
    } else if (event.button() == Qt::LeftButton) {
        const auto face = m_isEnabled ? held().faceAt(m_pointer) : std::nullopt;
        if (face)
            beginFaceDrag(*face, event);
        else
            beginOrbit(event, std::nullopt);
    }
    emit changed();
}

void SpaceInput::defineAt(const QPointF& position) {
    const auto vertices = m_definition.click(m_navigation.camera(), toVector(position));
    if (!vertices) {
        emit prompted();
    } else if (const auto failure = document::defineTetrahedron(*m_document, *vertices)) {
        emit message(*failure);
    } else {
        emit defined();
    }
}

bool SpaceInput::pressHandle(const QPointF& position, const QMouseEvent& event) {
    auto handles = held().handlesAt(position);
    if (const auto map = m_maps.mapAt(position); handles.empty() && m_maps.isActive() && map) {
        const bool adds = event.modifiers() == Qt::ShiftModifier;
        m_maps.pick(*map, adds);
        showSelected();
        if (adds) return true;
        handles = held().handlesAt(position);
    }
    if (handles.empty()) return false;
    // Of two, the one that Tab has chosen.
    const bool isChosen = m_focused && std::ranges::find(handles, *m_focused) != handles.end();
    beginDrag(isChosen ? *m_focused : handles.front(), event);
    return true;
}

void SpaceInput::showSelected() {
    m_focused.reset();
    m_hovered.reset();
    emit mapSelected();
}

SpaceInput::After SpaceInput::afterCage() {
    auto cage = document::knownSpaceCage(m_document->fractal());
    if (!cage) return nullptr;
    if (const QString obstacle = moveCageObstacle(*m_document); !obstacle.isEmpty()) {
        emit message(obstacle);
        return nullptr;
    }
    return [before = m_document->sharedFractal(), cage = *std::move(cage),
            mode = m_document->cageMode()](const std::vector<ifs::Vector<3>>& vertices) {
        auto moved = cage;
        moved.current = vertices;
        return document::withSpaceCageMoved(*before, std::move(moved), mode);
    };
}

std::optional<SpaceInput::Subject> SpaceInput::subject() {
    if (!holdsMap()) {
        After after = afterCage();
        return after ? std::optional(Subject{m_cage.vertices(), std::move(after)}) : std::nullopt;
    }
    QString obstacle;
    const auto drag = m_branch.isActive() ? m_branch.drag(obstacle) : m_maps.drag(obstacle);
    if (!drag) {
        emit message(obstacle);
        return std::nullopt;
    }
    const After after = [this, drag = *drag](const std::vector<ifs::Vector<3>>& vertices) {
        using Safety = SpaceMapDrag::Safety;
        SpaceMapDrag::Moved moved =
            drag.at(vertices, m_allowsNoAttractor ? Safety::Free : Safety::StopAtAttractor);
        emit stopped(moved.stop);
        return std::move(moved.fractal);
    };
    return Subject{drag->vertices(), after};
}

void SpaceInput::beginOrbit(const QMouseEvent& event, std::optional<AxisBall::End> end) {
    Orbiting orbiting;
    orbiting.before = m_navigation.camera();
    const bool onBall = m_isEnabled && !m_isFixed && m_ball.covers(event.position());
    const auto point = onBall ? std::nullopt : m_navigation.pointUnder(event.position());
    orbiting.pivot = onBall ? m_navigation.camera().target : point.value_or(m_navigation.pivotBeside());
    orbiting.press = event.position();
    orbiting.end = end;
    orbiting.button = event.button();
    m_gesture.emplace<Orbiting>(orbiting);
}

void SpaceInput::beginDrag(std::size_t vertex, const QMouseEvent& event) {
    if (vertex >= held().vertices().size()) return;
    std::optional<Subject> moved = subject();
    if (!moved) return;
    SpatialDrag drag;
    drag.camera = m_navigation.camera();
    drag.vertices = std::move(moved->vertices);
    drag.held = vertex;
    drag.press = toVector(event.position());
    if (event.modifiers().testFlag(Qt::ControlModifier)) drag.mode = SpatialDrag::Mode::Rotate;
    if (event.modifiers().testFlag(Qt::AltModifier)) drag.mode = SpatialDrag::Mode::Scale;
    const QString text = stepText(drag.mode, vertex);
    const Pull pull{drag.press, 0};
    m_focused = vertex;
    m_gesture.emplace<Dragging>(
        Dragging{m_document->beginGesture(text), std::move(moved->after), std::move(drag), pull, {}, false});
}

// Its corners follow its middle, which is held in place of a vertex.
void SpaceInput::beginFaceDrag(std::size_t face, const QMouseEvent& event) {
    const After after = afterCage();
    if (!after) return;
    SpatialDrag drag = faceDrag(m_navigation.camera(), m_cage.vertices(), m_cage.face(face));
    drag.press = toVector(event.position());
    const After cageAfter = [after](std::vector<ifs::Vector<3>> vertices) {
        vertices.pop_back();
        return after(vertices);
    };
    const Pull pull{drag.press, 0};
    m_focused.reset();
    m_face = face;
    m_gesture.emplace<Dragging>(Dragging{m_document->beginGesture(tr("Move Face %1").arg(face + 1)),
                                         cageAfter,
                                         std::move(drag),
                                         pull,
                                         {},
                                         false});
}

bool SpaceInput::isOnSymmetry(const QPointF& position) const {
    const auto knob = m_isEnabled ? m_symmetry.knob() : std::nullopt;
    return knob && QLineF(*knob, position).length() <= knobReach;
}

// Its centre is held in place of a vertex.
void SpaceInput::beginSymmetryDrag() {
    const auto centre = displayedCentre(m_document->fractal());
    After after = afterCentreMoved(m_document->sharedFractal());
    if (!centre || !after) return;
    SpatialDrag drag;
    drag.camera = m_navigation.camera();
    drag.vertices = {*centre};
    drag.press = toVector(m_pointer);
    const Pull pull{drag.press, 0};
    m_gesture.emplace<Dragging>(Dragging{m_document->beginGesture(tr("Move the centre of the symmetry")),
                                         std::move(after),
                                         std::move(drag),
                                         pull,
                                         {},
                                         false,
                                         true});
}

QString SpaceInput::stepText(SpatialDrag::Mode mode, std::size_t vertex) const {
    using enum SpatialDrag::Mode;
    if (m_branch.isActive()) return m_branch.stepText(mode, vertex);
    if (m_maps.selected()) return m_maps.stepText(mode, vertex);
    return mode == Rotate  ? tr("Rotate Cage")
           : mode == Scale ? tr("Scale Cage")
                           : tr("Move Vertex %1").arg(vertex + 1);
}

void SpaceInput::move(const QMouseEvent& event) {
    m_pointer = event.position();
    if (auto* orbiting = std::get_if<Orbiting>(&m_gesture)) {
        follow(*orbiting, m_pointer);
    } else if (auto* panning = std::get_if<Panning>(&m_gesture)) {
        m_navigation.moveTo(attractor::panned(panning->before, toVector(m_pointer - panning->press)), true);
    } else if (auto* dragging = std::get_if<Dragging>(&m_gesture)) {
        dragging->gesture.isOpen() ? follow(*dragging, event) : void(cancelDrag()); // undo may have ended it
    } else if (auto* slicing = std::get_if<Slicing>(&m_gesture)) {
        follow(*slicing, m_pointer);
    } else if (m_definition.isActive()) {
        m_hovered.reset();
        m_face.reset();
        m_definition.follow(m_navigation.camera(), toVector(m_pointer));
        report(m_pointer);
    } else {
        const auto handles = m_isEnabled ? held().handlesAt(m_pointer) : std::vector<std::size_t>();
        m_hovered = handles.empty() ? std::nullopt : std::optional(handles.front());
        m_face = m_isEnabled && !m_hovered && !isOnSlice(m_pointer) && !isOnSymmetry(m_pointer)
                     ? held().faceAt(m_pointer)
                     : std::nullopt;
        report(m_pointer);
    }
    emit changed();
}

void SpaceInput::follow(Orbiting& orbiting, const QPointF& position) {
    const QPointF delta = position - orbiting.press;
    if (!orbiting.hasMoved && std::hypot(delta.x(), delta.y()) < clickReach) return;
    if (m_isFixed) {
        orbiting.hasMoved = true;
        return m_navigation.moveTo(attractor::panned(orbiting.before, toVector(delta)), true);
    }
    if (!orbiting.hasMoved) {
        m_navigation.leaveAxisView();
        orbiting.before = m_navigation.camera();
        orbiting.hasMoved = true;
    }
    m_navigation.orbit(orbiting.before, orbiting.pivot, -degreesPerPixel * delta.x(),
                       degreesPerPixel * delta.y(), true);
    reportDirection();
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
    const bool isFace = !dragging.drag.together.empty();
    if (isFace && shift && dragging.lock.kind == AxisLock::Kind::View) {
        dragging.lock = {AxisLock::Kind::Normal, 0};
        dragging.isLockedByShift = true;
    } else if (shift && !dragging.isLockedByShift && dragging.lock.kind == AxisLock::Kind::View &&
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
    const auto vertices = dragged(dragging.drag, dragging.pull, dragging.lock);
    if (vertices == dragging.drag.vertices) {
        dragging.gesture.preview(dragging.gesture.before()); // where it began, to the bit
        emit stopped({});
    } else {
        dragging.gesture.preview(dragging.after(vertices));
    }
    if (m_branch.isActive()) m_branch.choice()->showDragged(vertices != dragging.drag.vertices);
    report(dragging);
}

// A branch may have become a map of its own, which the handles now hold.
void SpaceInput::endDrag() {
    emit stopped({});
    if (m_branch.isActive() && m_branch.choice()->endDrag())
        emit message(tr("This branch is now map 1. You can change it further in the table."));
}

void SpaceInput::chooseBranchAt(const QPointF& position) {
    const auto point = m_navigation.pointNear(position);
    if (!point) return m_branch.choice()->choose({});
    m_focused.reset();
    emit message(m_branch.chooseAt(*point, 1 / pixelsPerUnit(m_navigation.camera())));
}

void SpaceInput::release(const QMouseEvent& event) {
    if (auto* dragging = std::get_if<Dragging>(&m_gesture)) {
        if (event.button() != Qt::LeftButton) return;
        if (!dragging->gesture.isOpen()) return void(cancelDrag());
        dragging->gesture.commit();
        endDrag();
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
            m_navigation.lookAlong(*done.end);
        } else if (done.button == Qt::RightButton) {
            emit menuRequested(event.globalPosition().toPoint());
        } else if (m_branch.isActive()) {
            chooseBranchAt(event.position());
        }
    }
    m_gesture.emplace<std::monostate>();
    move(event);
}

void SpaceInput::handleDoubleClick(const QMouseEvent& event) {
    if (m_definition.isActive()) return press(event);
    const bool onHandle = m_isEnabled && !held().handlesAt(event.position()).empty();
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
    if (isIdle() && m_definition.isActive() && m_definition.isLifting()) {
        constexpr double share = 0.1;
        m_definition.lift(-share * notches(event));
        m_definition.follow(m_navigation.camera(), toVector(event.position()));
        return;
    }
    if (isIdle() && m_branch.isActive() && event.modifiers().testFlag(Qt::ShiftModifier))
        m_branch.choice()->turnDepth(event.angleDelta().x() + event.angleDelta().y());
    else if (isIdle())
        m_navigation.zoomAt(event.position(), std::pow(1.0015, event.angleDelta().y()));
}

void SpaceInput::leave() {
    m_hovered.reset();
    m_pointer = {-1, -1};
    m_isPointRead = false;
    emit pointerLeft();
    emit changed();
}

bool SpaceInput::needsKey(const QKeyEvent& event) const {
    if (!isIdle()) return isAxisKey(event) || event.key() == Qt::Key_Escape;
    if (m_definition.isActive() && (event.key() == Qt::Key_Escape || event.key() == Qt::Key_Backspace))
        return true;
    return m_ballFocus.needsKey(event) || event.key() == Qt::Key_Space ||
           !arrowDirection(event.key()).isNull() ||
           (isOnKeypad(event) && event.key() >= Qt::Key_0 && event.key() <= Qt::Key_9);
}

bool SpaceInput::keyPress(const QKeyEvent& event) {
    if (isIdle() && m_ballFocus.keyPress(event)) {
        emit changed();
        return true;
    }
    if (event.key() == Qt::Key_Escape && cancelGesture()) return true;
    if (event.key() == Qt::Key_Backspace && m_definition.isActive()) {
        m_definition.takeBack();
        emit prompted();
        return true;
    }
    if (isIdle() && !m_isFixed && lookBy(m_navigation, event)) return true;
    if (lockBy(event) || mapsKeyPress(event) || (isIdle() && m_branch.keyPress(event))) return true;
    if (event.key() == Qt::Key_Space) {
        m_isSpaceHeld = true;
        emit changed();
        return true;
    }
    const QPointF way = arrowDirection(event.key());
    if (way.isNull() || !isIdle()) return false;
    const bool isFast = event.modifiers().testFlag(Qt::ShiftModifier) && !m_ballFocus.isHere();
    const double factor = isFast ? 10 : 1; // on the ball, Shift alone makes the keys turn the view
    if (m_focused && *m_focused < held().vertices().size()) { // a branch that was let go has none
        nudge(factor * way);
    } else if (m_isFixed) {
        m_navigation.moveTo(attractor::panned(m_navigation.camera(), -pixelsPerKey * factor * toVector(way)));
    } else {
        m_navigation.leaveAxisView();
        const attractor::OrbitCamera& camera = m_navigation.camera();
        m_navigation.orbit(camera, camera.target, degreesPerKey * way.x(), -degreesPerKey * way.y());
        reportDirection();
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

bool SpaceInput::mapsKeyPress(const QKeyEvent& event) {
    if (!isIdle()) return false;
    const SpaceMaps::KeyOutcome outcome = m_maps.keyPress(event, *m_document);
    if (!outcome.message.isEmpty()) emit message(outcome.message);
    if (outcome.isSelected) showSelected();
    return outcome.isTaken;
}

void SpaceInput::nudge(const QPointF& pixels) {
    std::optional<Subject> moved = subject();
    if (!moved) return;
    SpatialDrag drag;
    drag.camera = m_navigation.camera();
    drag.vertices = std::move(moved->vertices);
    drag.held = *m_focused;
    m_document->edit(stepText(drag.mode, drag.held), moved->after(dragged(drag, {toVector(pixels), 0}, {})));
    if (m_branch.isActive()) m_branch.choice()->showDragged(true);
    endDrag();
}

bool SpaceInput::cancelGesture() {
    if (isIdle() && m_definition.isActive()) {
        emit defined();
        return true;
    }
    return cancelDrag();
}

bool SpaceInput::cancelDrag() {
    if (isIdle()) return false;
    if (auto* orbiting = std::get_if<Orbiting>(&m_gesture)) m_navigation.moveTo(orbiting->before);
    if (auto* panning = std::get_if<Panning>(&m_gesture)) m_navigation.moveTo(panning->before);
    m_gesture.emplace<std::monostate>(); // an edit is cancelled as it goes
    if (m_branch.isActive()) m_branch.choice()->cancelDrag();
    emit stopped({});
    emit changed();
    return true;
}

bool SpaceInput::moveFocus(bool next) {
    const std::size_t count = m_isEnabled ? held().count() : 0;
    const auto map = m_maps.selected();
    if (next && map && m_focused && *m_focused + 1 == count && *map + 1 < m_maps.count()) {
        m_maps.select(*map + 1); // and its first corner
        showSelected();
    }
    const std::size_t stops = count + (m_ballFocus.canTake() ? 1 : 0); // the ball is the last
    const std::optional<std::size_t> from = m_ballFocus.isHere() ? count : m_focused;
    const std::size_t stop = from ? (next ? *from + 1 : *from - 1) : (next ? 0 : stops - 1);
    m_focused = stop < count ? std::optional(stop) : std::nullopt;
    m_ballFocus.leave();
    if (stop >= count && stop < stops) m_ballFocus.take();
    emit changed();
    return stop < stops;
}

void SpaceInput::forgetFocus() {
    cancelGesture();
    m_ballFocus.leave();
    m_focused.reset();
    m_hovered.reset();
    m_face.reset();
}

void SpaceInput::fixDirection() {
    m_isFixed = true;
}

void SpaceInput::setEnabled(bool enabled) {
    cancelGesture();
    m_isEnabled = enabled;
}

void SpaceInput::showMarks(bool hasFocus) {
    std::optional<std::size_t> pressed;
    const auto* dragging = std::get_if<Dragging>(&m_gesture);
    if (dragging && !dragging->isOfSymmetry) pressed = dragging->drag.held;
    m_symmetry.setHeld(dragging && dragging->isOfSymmetry);
    const bool isSlicing = std::holds_alternative<Slicing>(m_gesture);
    m_slice.setHeld(isIdle() && !m_hovered && isOnSlice(m_pointer), isSlicing);
    m_cage.setFaceMark(m_face);
    held().setMarks(m_hovered, pressed, hasFocus ? m_focused : std::nullopt);
    m_ball.setFocused(hasFocus ? m_ballFocus.end() : std::nullopt);
    m_ball.setHovered(isIdle() && !m_isFixed ? m_ball.endAt(m_pointer) : std::nullopt);
}

Qt::CursorShape SpaceInput::cursor() const {
    if (std::holds_alternative<Dragging>(m_gesture) || std::holds_alternative<Panning>(m_gesture) ||
        std::holds_alternative<Slicing>(m_gesture))
        return Qt::ClosedHandCursor;
    if (isIdle() && (m_hovered || m_face || m_isSpaceHeld || isOnSlice(m_pointer) || isOnSymmetry(m_pointer)))
        return Qt::OpenHandCursor;
    if (isIdle() && m_isEnabled && !m_isFixed && m_ball.covers(m_pointer)) return Qt::PointingHandCursor;
    return Qt::CrossCursor;
}

void SpaceInput::report(const QPointF& position) {
    if (!document::space(m_document->fractal())) return;
    m_isPointRead = true;
    emit pointerMoved(positionAt(m_document->fractal(), m_navigation, m_cage.vertices(), position));
}

void SpaceInput::reportDirection() {
    m_isPointRead = false;
    SpacePosition at;
    at.world = m_navigation.camera().target;
    at.unitsPerPixel = 1 / pixelsPerUnit(m_navigation.camera());
    at.direction = attractor::directionOf(m_navigation.camera(), m_navigation.upAxis());
    emit pointerMoved(at);
}

// Where the corner is now, and how it may move.
void SpaceInput::report(const Dragging& dragging) {
    if (held().vertices().empty()) return;
    SpacePosition at;
    at.world = ifs::Vector<3>::Zero(); // of a face, its middle
    const std::vector<int>& together = dragging.drag.together;
    if (dragging.isOfSymmetry)
        at.world = displayedCentre(m_document->fractal()).value_or(at.world);
    else if (together.empty() && dragging.drag.held < held().vertices().size())
        at.world = held().vertices()[dragging.drag.held];
    for (const int corner : together)
        at.world += held().vertices()[std::size_t(corner)] / double(together.size());
    at.unitsPerPixel = 1 / pixelsPerUnit(dragging.drag.camera);
    at.lock = dragging.lock;
    emit pointerMoved(at);
}

} // namespace view
