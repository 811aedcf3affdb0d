// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/symmetry_item.h"
#include "space/axis_ball_focus.h"
#include "space/slice_item.h"
#include "space/space_branch.h"
#include "space/space_cage_item.h"
#include "space/space_definition.h"
#include "space/space_maps.h"
#include "space/space_navigation.h"
#include "space/space_position.h"
#include "space/spatial_drag.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <functional>
#include <optional>
#include <variant>
#include <vector>

namespace view {

// What mouse and keyboard do in the window into space: orbit, pan, and drag vertices. One gesture at a time.
class SpaceInput : public QObject {
    Q_OBJECT

public:
    // What can be held on the canvas: the cage, or the maps or a branch while they are active.
    struct Items {
        SpaceCageItem& cage;
        SpaceMaps& maps;
        SpaceBranch& branch;
        SpaceCageItem& map; // the one that is held, or the branch
        SpaceDefinition& definition;
        SliceItem& slice;
        SymmetryItem& symmetry;
        AxisBall& ball;
    };
    SpaceInput(document::Document* document, SpaceNavigation& navigation, const Items& items);

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void handleDoubleClick(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    void leave();
    void reportAgain() { // when the camera or the picture under the pointer is another one
        if (m_isPointRead && isIdle()) report(m_pointer);
    }
    bool needsKey(const QKeyEvent& event) const; // more than the shortcuts of the window
    bool keyPress(const QKeyEvent& event);       // false when it means nothing here
    void keyRelease(const QKeyEvent& event);
    bool cancelGesture();          // a definition, too; false when none was under way
    bool cancelDrag();             // false when nothing was dragged
    bool moveFocus(bool next);     // to the next or previous vertex; after the last, the ball; false past it
    void forgetFocus();            // of another fractal
    void setEnabled(bool enabled); // handles and ball can be held
    void fixDirection();           // nothing turns the view: a drag pans instead
    // A drag of a map stops where the attractor would be lost, unless this is allowed.
    void setAllowsNoAttractor(bool allows) { m_allowsNoAttractor = allows; }

    std::optional<std::size_t> focusedVertex() const { return m_focused; }
    void showMarks(bool hasFocus); // on the items, as things are
    Qt::CursorShape cursor() const;

signals:
    void changed(); // marks or cursor
    void pointerMoved(const view::SpacePosition& position);
    void pointerLeft();
    void mapSelected();               // another one is held
    void stopped(const QString& why); // a drag; empty: it goes on, or has ended
    void message(const QString& sentence);
    void defined();                           // a tetrahedron, or given up
    void prompted();                          // the next click has another meaning
    void menuRequested(const QPoint& global); // by a click of the right button

private:
    struct Orbiting {
        attractor::OrbitCamera before;
        ifs::Vector<3> pivot = ifs::Vector<3>::Zero();
        QPointF press;
        std::optional<AxisBall::End> end; // pressed on the ball: a click looks along it
        Qt::MouseButton button = Qt::LeftButton;
        bool hasMoved = false;
    };
    struct Panning {
        attractor::OrbitCamera before;
        QPointF press;
    };
    struct Slicing {
        document::EditGesture gesture;
        attractor::OrbitCamera camera;
        SlicePlane plane;
        ifs::Vector<2> press;
    };
    using After = std::function<document::Fractal(const std::vector<ifs::Vector<3>>&)>;
    struct Dragging {
        document::EditGesture gesture;
        After after; // the fractal with the vertices there
        SpatialDrag drag;
        Pull pull;
        AxisLock lock;
        bool isLockedByShift = false;
        bool isOfSymmetry = false; // its centre
    };

    bool isIdle() const { return std::holds_alternative<std::monostate>(m_gesture); }
    void beginOrbit(const QMouseEvent& event, std::optional<AxisBall::End> end);
    bool pressHandle(const QPointF& position, const QMouseEvent& event); // false: there is none
    void beginDrag(std::size_t vertex, const QMouseEvent& event);
    QString stepText(SpatialDrag::Mode mode, std::size_t vertex) const;
    void beginFaceDrag(std::size_t face, const QMouseEvent& event);
    After afterCage(); // nullptr while there is no cage, or, which is said, while it cannot move
    // What is held: the cage, the selected maps or a branch. nullopt, which is said, while it cannot move.
    struct Subject {
        std::vector<ifs::Vector<3>> vertices; // of several maps, those of the held one first
        After after;
    };
    std::optional<Subject> subject();
    void showSelected();
    bool mapsKeyPress(const QKeyEvent& event);
    bool holdsMap() const { return m_maps.isActive() || m_branch.isActive(); } // or a branch
    SpaceCageItem& held() const { return holdsMap() ? m_map : m_cage; }
    void endDrag();
    void chooseBranchAt(const QPointF& position);
    void follow(Orbiting& orbiting, const QPointF& position);
    void follow(Dragging& dragging, const QMouseEvent& event);
    void follow(Slicing& slicing, const QPointF& position);
    bool isOnSlice(const QPointF& position) const;
    bool isOnSymmetry(const QPointF& position) const;
    void beginSymmetryDrag();
    void preview(Dragging& dragging);
    void report(const Dragging& dragging);
    void nudge(const QPointF& pixels);
    void defineAt(const QPointF& position);
    bool lockBy(const QKeyEvent& event);
    void report(const QPointF& position);
    void reportDirection();

    document::Document* m_document;
    SpaceNavigation& m_navigation;
    SpaceCageItem& m_cage;
    SpaceMaps& m_maps;
    SpaceBranch& m_branch;
    SpaceCageItem& m_map;
    SpaceDefinition& m_definition;
    SliceItem& m_slice;
    SymmetryItem& m_symmetry;
    AxisBall& m_ball;
    AxisBallFocus m_ballFocus;
    std::variant<std::monostate, Orbiting, Panning, Dragging, Slicing> m_gesture;
    QPointF m_pointer{-1, -1};  // when it is elsewhere
    bool m_isPointRead = false; // what was reported last is under the pointer
    std::optional<std::size_t> m_hovered;
    std::optional<std::size_t> m_focused;
    std::optional<std::size_t> m_face; // hovered or held
    bool m_allowsNoAttractor = false;
    bool m_isFixed = false;
    bool m_isEnabled = true;
    bool m_isSpaceHeld = false;
};

} // namespace view
