// SPDX-License-Identifier: MIT
#include "space/space_input.h"

#include "attractor/request/orbit_navigation.h"
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/tools/map_gestures.h"
#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/cage/space_cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "space/keypad_views.h"
#include "space/space_symmetry.h"
#include "widgets/arrow_keys.h"

#include <QKeyEvent>
#include <QLineF>
#include <QWheelEvent>

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
constexpr double pushPixels = 20; // pixels for one notch of the wheel

// X, Y or Z of a drag; with Ctrl they are shortcuts of the window.
bool isAxisKey(const QKeyEvent& event) {
    const bool isShortcut = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    return !isShortcut && event.key() >= Qt::Key_X && event.key() <= Qt::Key_Z;
}

} // namespace

SpaceInput::SpaceInput(document::Document* document, SpaceNavigation& navigation, const Items& items)
    : ViewportInput(navigation),
      m_document(document),
      m_navigation(navigation),
      m_cage(items.cage),
      m_maps(items.maps),
      m_branch(items.branch),
      m_map(items.map),
      m_definition(items.definition),
      m_slice(items.slice),
      m_symmetry(items.symmetry),
      m_ball(items.ball),
      m_arrows(items.arrows),
      m_ballFocus(m_ball, navigation),
      m_session(*document) {
    connect(&m_session, &DragSession::runEnded, this, &SpaceInput::settle);
}

bool SpaceInput::pressed(Qt::MouseButton button) {
    const QPointF position = pointer().position;
    m_session.endRun();
    m_session.press(position);
    if (!m_ball.covers(position)) m_ballFocus.leave();
    if (button == Qt::RightButton || (button == Qt::LeftButton && isOnBall())) {
        beginOrbit(button);
        return !isIdle();
    }
    if (button != Qt::LeftButton) return false;
    if (m_isEnabled && m_definition.isActive()) {
        define();
    } else if (m_isEnabled && pressHandle()) {
        // Already held.
    } else if (arrowUnder()) {
        m_navigation.fit();
    } else if (isOnSymmetry()) {
        beginSymmetryDrag();
    } else if (isOnSlice()) {
        m_gesture.emplace<Slicing>(Slicing{m_navigation.camera(), *m_slice.plane()});
        m_session.open(tr("Move the Slice"));
    } else if (const auto face = m_isEnabled ? held().faceAt(position) : std::nullopt) {
        beginFaceDrag(*face);
    } else {
        beginOrbit(button);
    }
    return !isIdle();
}

void SpaceInput::define() {
    const auto vertices = m_definition.click(m_navigation.camera(), toVector(pointer().position));
    if (!vertices) {
        emit prompted();
    } else if (const auto failure = document::defineTetrahedron(*m_document, *vertices)) {
        emit message(*failure);
    } else {
        emit defined();
    }
}

bool SpaceInput::isOnHandle() const {
    if (!m_isEnabled || m_definition.isActive()) return false;
    const QPointF position = pointer().position;
    return !held().handlesAt(position).empty() || (m_maps.isActive() && m_maps.mapAt(position));
}

bool SpaceInput::pressHandle() {
    const QPointF position = pointer().position;
    auto handles = held().handlesAt(position);
    if (const auto map = m_maps.mapAt(position); handles.empty() && m_maps.isActive() && map) {
        const bool adds = pointer().modifiers == Qt::ShiftModifier;
        m_maps.pick(*map, adds);
        showSelected();
        if (adds) return true;
        handles = held().handlesAt(position);
    }
    if (handles.empty()) return false;
    // True for a handle chosen with Tab among two.
    const bool isChosen = m_focused && std::ranges::find(handles, *m_focused) != handles.end();
    beginDrag(isChosen ? *m_focused : handles.front());
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
        return document::withCageMoved(*before, std::move(moved), mode);
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

void SpaceInput::beginOrbit(Qt::MouseButton button) {
    const bool turnsBall = isOnBall() && button == Qt::LeftButton;
    const auto point = isOnBall() ? std::nullopt : m_navigation.pointUnder(pointer().position);
    const ifs::Vector<3> pivot =
        isOnBall() ? m_navigation.camera().target : point.value_or(m_navigation.pivotBeside());
    m_gesture.emplace<Orbiting>(Orbiting{
        m_navigation.camera(), pivot, turnsBall ? m_ball.endAt(pointer().position) : std::nullopt, button});
}

void SpaceInput::begin(Dragging dragging, const QString& step) {
    dragging.drag.camera = m_navigation.camera();
    dragging.drag.press = toVector(m_session.pressedAt());
    dragging.pull.pointer = dragging.drag.press;
    m_gesture.emplace<Dragging>(std::move(dragging));
    m_session.open(step);
}

void SpaceInput::beginDrag(std::size_t vertex) {
    if (vertex >= held().vertices().size()) return;
    std::optional<Subject> moved = subject();
    if (!moved) return;
    SpatialDrag drag;
    drag.vertices = std::move(moved->vertices);
    drag.held = vertex;
    drag.mode = dragMode(pointer().modifiers);
    m_focused = vertex;
    const QString step = stepText(drag.mode, vertex);
    begin({std::move(moved->after), std::move(drag)}, step);
}

// Holds the middle of the face in place of a vertex; its corners follow.
void SpaceInput::beginFaceDrag(std::size_t face) {
    const After after = afterCage();
    if (!after) return;
    const After cageAfter = [after](std::vector<ifs::Vector<3>> vertices) {
        vertices.pop_back();
        return after(vertices);
    };
    m_focused.reset();
    m_face = face;
    begin({cageAfter, faceDrag(m_cage.vertices(), m_cage.face(face)), Part::Face},
          tr("Move Face %1").arg(face + 1));
}

bool SpaceInput::isOnSymmetry() const {
    const auto knob = m_isEnabled ? m_symmetry.knob() : std::nullopt;
    return knob && QLineF(*knob, pointer().position).length() <= knobReach;
}

// Holds the centre of the symmetry in place of a vertex.
void SpaceInput::beginSymmetryDrag() {
    const auto centre = displayedCentre(m_document->fractal());
    After after = afterCentreMoved(m_document->sharedFractal());
    if (!centre || !after) return;
    SpatialDrag drag;
    drag.vertices = {*centre};
    begin({std::move(after), std::move(drag), Part::Symmetry}, tr("Move the centre of the symmetry"));
}

QString SpaceInput::stepText(SpatialDrag::Mode mode, std::size_t vertex) const {
    const auto corner = vertex == SpaceMaps::middle ? std::nullopt : std::optional(vertex);
    if (m_branch.isActive()) return m_branch.stepText(mode, corner);
    if (m_maps.selected()) return m_maps.stepText(mode, corner);
    if (mode == DragMode::Rotate) return tr("Rotate Cage");
    return mode == DragMode::Scale ? tr("Scale Cage") : tr("Move Vertex %1").arg(vertex + 1);
}

void SpaceInput::moved() {
    if (auto* orbiting = std::get_if<Orbiting>(&m_gesture)) {
        follow(*orbiting);
    } else if (!isIdle() && !m_session.isOpen()) {
        cancelDrag(); // ended by undo
    } else if (auto* dragging = std::get_if<Dragging>(&m_gesture)) {
        follow(*dragging);
    } else if (const auto* slicing = std::get_if<Slicing>(&m_gesture)) {
        follow(*slicing);
    } else {
        hover();
    }
}

void SpaceInput::hover() {
    const QPointF position = pointer().position;
    m_hovered.reset();
    m_face.reset();
    if (m_definition.isActive()) {
        m_definition.follow(m_navigation.camera(), toVector(position));
    } else if (m_isEnabled) {
        const auto handles = held().handlesAt(position);
        if (!handles.empty()) m_hovered = handles.front();
        if (!m_hovered && !isOnSlice() && !isOnSymmetry()) m_face = held().faceAt(position);
    }
    markArrow();
    report(position);
}

std::optional<BorderArrow> SpaceInput::arrowUnder() const {
    if (!m_isEnabled || !isIdle() || m_definition.isActive() || !m_arrows.isVisible() || isOnHandle())
        return std::nullopt;
    return m_arrows.arrowAt(pointer().position, pointer().reach == Reach::Touch
                                                    ? BorderArrowsItem::fingerReach
                                                    : BorderArrowsItem::mouseReach);
}

void SpaceInput::markArrow() {
    const auto arrow = arrowUnder();
    const int before = m_arrows.hovered();
    m_arrows.setHovered(arrow ? arrow->vertex : -1);
    if (before < 0 && arrow) emit message(cornerOutside());
    if (before >= 0 && !arrow) emit message({});
}

void SpaceInput::follow(Orbiting& orbiting) {
    const QPointF delta = pointer().position - m_session.pressedAt();
    if (!orbiting.hasMoved && std::hypot(delta.x(), delta.y()) < clickReach) return;
    if (m_navigation.isFixed()) {
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

void SpaceInput::follow(const Slicing& slicing) {
    document::Fractal moved = m_session.gesture().before();
    if (!moved.inSpace.clip || !m_session.isDrag(pointer().position)) return;
    moved.inSpace.clip =
        slid(*moved.inSpace.clip, slideBetween(slicing.camera, slicing.plane, toVector(m_session.pressedAt()),
                                               toVector(pointer().position)));
    if (isUsable(*moved.inSpace.clip)) m_session.gesture().preview(moved);
}

void SpaceInput::follow(Dragging& dragging) {
    if (!m_session.isDrag(pointer().position)) return;
    SpatialDrag& drag = dragging.drag;
    // False for an axis chosen by its key, since Ctrl may belong to a shortcut.
    const bool canTurn = dragging.part == Part::Vertex &&
                         (dragging.isLockedByShift || dragging.lock.kind == AxisLock::Kind::View);
    if (const auto mode = m_session.turnedInto(dragMode(pointer().modifiers), drag.mode); mode && canTurn) {
        if (m_branch.isActive()) m_branch.choice()->showDragged(false);
        drag.mode = *mode;
        m_session.describe(stepText(drag.mode, drag.held), drag.held);
    }
    dragging.pull.pointer = toVector(pointer().position);
    const bool shift = pointer().modifiers.testFlag(Qt::ShiftModifier);
    const ifs::Vector<2> motion = dragging.pull.pointer - drag.press;
    if (dragging.part == Part::Face && shift && dragging.lock.kind == AxisLock::Kind::View) {
        dragging.lock = {AxisLock::Kind::Normal, 0};
        dragging.isLockedByShift = true;
    } else if (shift && !dragging.isLockedByShift && dragging.lock.kind == AxisLock::Kind::View &&
               motion.norm() >= shiftReach) {
        if (const auto axis = nearestAxis(drag.camera, drag.vertices[drag.held], motion)) {
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
    const bool hasMoved = vertices != dragging.drag.vertices;
    if (!hasMoved) emit stopped({});
    m_session.gesture().preview(hasMoved ? dragging.after(vertices)
                                         : m_session.gesture().before()); // initial state, bit for bit
    if (m_branch.isActive()) m_branch.choice()->showDragged(hasMoved);
    if (!m_session.isRunning()) report(dragging);
}

// A branch may have become a map of its own, which the handles now hold.
void SpaceInput::settle() {
    const DragSession::Outcome outcome = m_session.finish();
    if (outcome == DragSession::Outcome::None) return;
    emit stopped({});
    if (!m_branch.isActive()) return;
    if (outcome == DragSession::Outcome::Abandoned)
        m_branch.choice()->cancelDrag();
    else if (const QString said = m_branch.choice()->endDrag(); !said.isEmpty())
        emit message(said);
}

void SpaceInput::chooseBranch() {
    const auto point = m_navigation.pointNear(pointer().position);
    if (!point) return m_branch.choice()->choose({});
    m_focused.reset();
    emit message(m_branch.chooseAt(*point, 1 / pixelsPerUnit(m_navigation.camera())));
}

void SpaceInput::released() {
    settle();
    const auto* orbiting = std::get_if<Orbiting>(&m_gesture);
    const auto done = orbiting ? std::optional(*orbiting) : std::nullopt;
    m_gesture.emplace<std::monostate>();
    if (done && done->hasMoved) {
        m_navigation.moveTo(m_navigation.camera());
    } else if (done && done->end) {
        m_navigation.lookAlong(*done->end);
    } else if (done && done->button == Qt::RightButton) {
        emit menuRequested(pointer().position);
    } else if (done && m_branch.isActive()) {
        chooseBranch();
    }
    hover();
}

bool SpaceInput::doubleClicked() {
    if (m_definition.isActive()) return false;
    const bool onHandle = m_isEnabled && !held().handlesAt(pointer().position).empty();
    const auto point = m_navigation.pointUnder(pointer().position);
    if (!point || onHandle) return false;
    m_navigation.glideTo(attractor::centredOn(m_navigation.camera(), *point));
    return true;
}

bool SpaceInput::wheelTurned(const QWheelEvent& event) {
    if (auto* dragging = std::get_if<Dragging>(&m_gesture)) {
        dragging->pull.away += notches(event) * pushPixels / pixelsPerUnit(dragging->drag.camera);
        preview(*dragging);
        return true;
    }
    if (!isIdle()) return true;
    if (m_definition.isActive() && m_definition.isLifting()) {
        constexpr double share = 0.1;
        m_definition.lift(-share * notches(event));
        m_definition.follow(m_navigation.camera(), toVector(event.position()));
        return true;
    }
    const bool chooses = m_branch.isActive() && event.modifiers().testFlag(Qt::ShiftModifier);
    if (chooses) m_branch.choice()->turnDepth(event.angleDelta().x() + event.angleDelta().y());
    return chooses;
}

void SpaceInput::left() {
    m_hovered.reset();
    forgetPointer();
    m_isPointRead = false;
}

bool SpaceInput::needsKey(const QKeyEvent& event) const {
    if (!isIdle()) return isAxisKey(event) || event.key() == Qt::Key_Escape;
    if (m_definition.isActive() && (event.key() == Qt::Key_Escape || event.key() == Qt::Key_Backspace))
        return true;
    return ViewportInput::needsKey(event) || m_ballFocus.needsKey(event) ||
           (isOnKeypad(event) && event.key() >= Qt::Key_0 && event.key() <= Qt::Key_9);
}

bool SpaceInput::keyPressed(const QKeyEvent& event) {
    const QPointF way = arrowDirection(event.key());
    if (way.isNull() && event.key() != Qt::Key_Escape) m_session.endRun();
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
    if (isIdle() && !m_navigation.isFixed() && lookBy(m_navigation, event)) return true;
    if (lockBy(event) || mapsKeyPress(event) || (isIdle() && m_branch.keyPress(event))) return true;
    if (way.isNull() || !isIdle()) return false;
    m_session.keepRun(event);
    // Shift alone turns the view on the ball.
    const QPointF by = way * (m_ballFocus.isHere() ? 1 : nudgePace(event.modifiers()));
    if (m_focused && *m_focused < held().vertices().size()) { // not so for a released branch
        nudge(by);
    } else if (m_navigation.isFixed()) {
        m_navigation.moveTo(attractor::panned(m_navigation.camera(), -pixelsPerKey * toVector(by)));
    } else {
        m_navigation.leaveAxisView();
        const attractor::OrbitCamera& camera = m_navigation.camera();
        m_navigation.orbit(camera, camera.target, degreesPerKey * by.x(), -degreesPerKey * by.y());
        reportDirection();
    }
    return true;
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
    if (!isIdle() || !m_maps.isActive() || m_maps.count() == 0) return false;
    const MapKey key = pressMapKey(event, *m_document, m_maps.selection());
    if (!key.message.isEmpty()) emit message(key.message);
    if (!key.selected.empty() && m_maps.selectIds(key.selected)) showSelected();
    return key.isTaken;
}

// Makes one undo step for as long as the key is held.
void SpaceInput::nudge(const QPointF& pixels) {
    if (!m_session.isRunning()) {
        std::optional<Subject> moved = subject();
        if (!moved) return;
        SpatialDrag drag;
        drag.camera = m_navigation.camera();
        drag.vertices = std::move(moved->vertices);
        drag.held = *m_focused;
        m_nudging = {std::move(moved->after), std::move(drag)};
        m_session.open(stepText(DragMode::Move, *m_focused));
        m_session.beginRun();
    }
    if (!m_session.isOpen()) return m_session.endRun();
    m_nudging.pull.pointer += toVector(pixels);
    preview(m_nudging);
    m_session.describe(m_session.text(), *m_focused);
}

bool SpaceInput::cancelled() {
    if (isIdle() && m_definition.isActive()) {
        emit defined();
        return true;
    }
    if (isIdle() && !m_session.isRunning()) return false;
    cancelDrag();
    return true;
}

void SpaceInput::cancelDrag() {
    if (isIdle() && !m_session.isRunning()) return;
    if (const auto* orbiting = std::get_if<Orbiting>(&m_gesture)) m_navigation.moveTo(orbiting->before);
    m_gesture.emplace<std::monostate>();
    letGo();
    m_session.cancel();
    if (m_branch.isActive()) m_branch.choice()->cancelDrag();
    emit stopped({});
    emit changed();
}

bool SpaceInput::moveFocus(bool next) {
    m_session.endRun();
    const std::size_t count = m_isEnabled ? held().count() : 0;
    const auto map = m_maps.selected();
    if (next && map && m_focused && *m_focused + 1 == count && *map + 1 < m_maps.count()) {
        m_maps.select(*map + 1); // also its first corner
        showSelected();
    }
    const std::size_t stops = count + (m_ballFocus.canTake() ? 1 : 0); // last stop: the ball
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

void SpaceInput::setEnabled(bool enabled) {
    cancelGesture();
    m_isEnabled = enabled;
}

void SpaceInput::showMarks(bool hasFocus) {
    std::optional<std::size_t> pressed;
    const auto* dragging = std::get_if<Dragging>(&m_gesture);
    if (dragging && dragging->part != Part::Symmetry) pressed = dragging->drag.held;
    m_symmetry.setHeld(dragging && dragging->part == Part::Symmetry);
    const bool isSlicing = std::holds_alternative<Slicing>(m_gesture);
    m_slice.setHeld(isIdle() && !m_hovered && isOnSlice(), isSlicing);
    m_cage.setFaceMark(m_face);
    held().setMarks(m_hovered, pressed, hasFocus ? m_focused : std::nullopt);
    m_ball.setFocused(hasFocus ? m_ballFocus.end() : std::nullopt);
    m_ball.setHovered(isIdle() && isOnBall() ? m_ball.endAt(pointer().position) : std::nullopt);
}

QCursor SpaceInput::cursorOver() const {
    const bool isDragging = !isIdle() && !std::holds_alternative<Orbiting>(m_gesture);
    if (isDragging) return Qt::ClosedHandCursor;
    if (isIdle() && (m_hovered || m_face || isOnSlice() || isOnSymmetry())) return Qt::OpenHandCursor;
    return arrowUnder() || (isIdle() && isOnBall()) ? Qt::PointingHandCursor : Qt::CrossCursor;
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

// Reports the position of the corner, and how it may move.
void SpaceInput::report(const Dragging& dragging) {
    if (held().vertices().empty()) return;
    SpacePosition at;
    at.world = ifs::Vector<3>::Zero(); // middle of a face
    const std::vector<int>& together = dragging.drag.together;
    if (dragging.part == Part::Symmetry)
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
