// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/border_arrows_item.h"
#include "canvas/items/symmetry_item.h"
#include "gestures/drag_session.h"
#include "gestures/viewport_input.h"
#include "space/axis_ball_focus.h"
#include "space/slice_item.h"
#include "space/space_branch.h"
#include "space/space_cage_item.h"
#include "space/space_definition.h"
#include "space/space_maps.h"
#include "space/space_navigation.h"
#include "space/space_position.h"
#include "space/spatial_drag.h"

#include <functional>
#include <optional>
#include <variant>
#include <vector>

namespace view {

// Input of pointer, wheel, fingers and keys in the window into space: orbit, pan, and drag vertices.
class SpaceInput : public ViewportInput {
    Q_OBJECT

public:
    // Items that can be held on the canvas: the cage, or the maps or a branch while they are active.
    struct Items {
        SpaceCageItem& cage;
        SpaceMaps& maps;
        SpaceBranch& branch;
        SpaceCageItem& map; // the one that is held, or the branch
        SpaceDefinition& definition;
        SliceItem& slice;
        SymmetryItem& symmetry;
        AxisBall& ball;
        BorderArrowsItem& arrows;
    };
    SpaceInput(document::Document* document, SpaceNavigation& navigation, const Items& items);

    void reportAgain() { // when the camera or the picture under the pointer is another one
        if (m_isPointRead && isIdle()) report(pointer().position);
    }
    bool needsKey(const QKeyEvent& event) const override;
    void cancelDrag() override;
    bool moveFocus(bool next);     // to the next or previous vertex; after the last, the ball; false past it
    void forgetFocus();            // when another entry is shown
    void setEnabled(bool enabled); // handles and ball can be held
    // A drag of a map stops where the attractor would be lost, unless this is allowed.
    void setAllowsNoAttractor(bool allows) { m_allowsNoAttractor = allows; }

    std::optional<std::size_t> focusedVertex() const { return m_focused; }
    void showMarks(bool hasFocus); // on the items, as things are

signals:
    void pointerMoved(const view::SpacePosition& position);
    void mapSelected();                          // another one is held
    void stopped(const QString& why);            // a drag; empty: it goes on, or has ended
    void defined();                              // a tetrahedron, or given up
    void prompted();                             // the next click has another meaning
    void menuRequested(const QPointF& position); // by a click of the right button

protected:
    bool pressed(Qt::MouseButton button) override;
    void pressedMore() override { cancelGesture(); }
    bool doubleClicked() override;
    void moved() override;
    void released() override;
    void left() override;
    bool wheelTurned(const QWheelEvent& event) override;
    bool keyPressed(const QKeyEvent& event) override;
    bool keyReleased(const QKeyEvent& event) override { return m_session.releaseRun(event); }
    bool cancelled() override; // a definition, too
    QCursor cursorOver() const override;

private:
    struct Orbiting {
        attractor::OrbitCamera before;
        ifs::Vector<3> pivot;
        std::optional<AxisBall::End> end; // pressed on the ball: a click looks along it
        Qt::MouseButton button;
        bool hasMoved = false;
    };
    struct Slicing {
        attractor::OrbitCamera camera;
        SlicePlane plane;
    };
    using After = std::function<document::Fractal(const std::vector<ifs::Vector<3>>&)>;
    enum class Part { Vertex, Face, Symmetry };
    struct Dragging {
        After after; // the fractal with the vertices there
        SpatialDrag drag;
        Part part = Part::Vertex;
        Pull pull{};
        AxisLock lock{};
        bool isLockedByShift = false;
    };

    bool isIdle() const { return std::holds_alternative<std::monostate>(m_gesture); }
    bool isOnBall() const {
        return m_isEnabled && !m_navigation.isFixed() && m_ball.covers(pointer().position) && !isOnHandle();
    }
    bool isOnHandle() const; // a corner of the cage or of a map
    void beginOrbit(Qt::MouseButton button);
    bool pressHandle(); // false: there is none
    void beginDrag(std::size_t vertex);
    void begin(Dragging dragging, const QString& step); // at the press
    QString stepText(SpatialDrag::Mode mode, std::size_t vertex) const;
    void beginFaceDrag(std::size_t face);
    After afterCage(); // nullptr while there is no cage, or, which is said, while it cannot move
    // The held object: the cage, the selected maps or a branch. nullopt, with a message, while it cannot
    // move.
    struct Subject {
        std::vector<ifs::Vector<3>> vertices; // of several maps, those of the held one first
        After after;
    };
    std::optional<Subject> subject();
    void showSelected();
    bool mapsKeyPress(const QKeyEvent& event);
    bool holdsMap() const { return m_maps.isActive() || m_branch.isActive(); } // or a branch
    std::optional<BorderArrow> arrowUnder() const;                             // to a corner outside the view
    void markArrow();
    SpaceCageItem& held() const { return holdsMap() ? m_map : m_cage; }
    void settle();
    void chooseBranch();
    void follow(Orbiting& orbiting);
    void follow(Dragging& dragging);
    void follow(const Slicing& slicing);
    void hover();
    bool isOnSlice() const { return m_isEnabled && m_slice.isHandleAt(pointer().position); }
    bool isOnSymmetry() const;
    void beginSymmetryDrag();
    void preview(Dragging& dragging);
    void report(const Dragging& dragging);
    void nudge(const QPointF& pixels);
    void define();
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
    BorderArrowsItem& m_arrows;
    AxisBallFocus m_ballFocus;
    std::variant<std::monostate, Orbiting, Dragging, Slicing> m_gesture;
    DragSession m_session;      // of Dragging, Slicing and m_nudging
    Dragging m_nudging;         // while an arrow key is held
    bool m_isPointRead = false; // the last report is still under the pointer
    std::optional<std::size_t> m_hovered;
    std::optional<std::size_t> m_focused;
    std::optional<std::size_t> m_face; // hovered or held
    bool m_allowsNoAttractor = false;
    bool m_isEnabled = true;
};

} // namespace view
