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
        SpaceCageItem& map; // held map, or the branch
        SpaceDefinition& definition;
        SliceItem& slice;
        SymmetryItem& symmetry;
        AxisBall& ball;
        BorderArrowsItem& arrows;
    };
    SpaceInput(document::Document* document, SpaceNavigation& navigation, const Items& items);

    void reportAgain() { // called when the camera or the picture under the pointer has changed
        if (m_isPointRead && isIdle()) report(pointer().position);
    }
    bool needsKey(const QKeyEvent& event) const override;
    void cancelDrag() override;
    bool moveFocus(bool next);     // next or previous vertex, then the ball; false at the end
    void forgetFocus();            // called when another entry is shown
    void setEnabled(bool enabled); // false: handles and ball cannot be held
    // A drag of a map stops where the attractor would be lost, unless this is allowed.
    void setAllowsNoAttractor(bool allows) { m_allowsNoAttractor = allows; }

    std::optional<std::size_t> focusedVertex() const { return m_focused; }
    void showMarks(bool hasFocus); // updates the marks on the items

signals:
    void pointerMoved(const view::SpacePosition& position);
    void mapSelected();               // sent when another map is held
    void stopped(const QString& why); // reason why a drag stops; empty: it continues or has ended
    void defined();                   // sent when a tetrahedron is defined or the definition is cancelled
    void prompted();                  // sent when the next click has another effect
    void menuRequested(const QPointF& position); // sent for clicks of the right button

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
    bool cancelled() override; // also cancels a definition
    QCursor cursorOver() const override;

private:
    struct Orbiting {
        attractor::OrbitCamera before;
        ifs::Vector<3> pivot;
        std::optional<AxisBall::End> end; // end pressed on the ball: a click looks along it
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
        After after; // fractal with the given vertices
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
    bool isOnHandle() const; // true over a corner of the cage or of a map
    void beginOrbit(Qt::MouseButton button);
    bool pressHandle(); // false if there is no handle
    void beginDrag(std::size_t vertex);
    void begin(Dragging dragging, const QString& step); // called at the press
    QString stepText(SpatialDrag::Mode mode, std::size_t vertex) const;
    void beginFaceDrag(std::size_t face);
    After afterCage(); // null if there is no cage or, with a message, if the cage cannot move
    // The held object: the cage, the selected maps or a branch. nullopt, with a message, while it cannot
    // move.
    struct Subject {
        std::vector<ifs::Vector<3>> vertices; // vertices; of several maps, those of the held map first
        After after;
    };
    std::optional<Subject> subject();
    void showSelected();
    bool mapsKeyPress(const QKeyEvent& event);
    bool holdsMap() const { return m_maps.isActive() || m_branch.isActive(); } // also true for a branch
    std::optional<BorderArrow> arrowUnder() const; // arrow to a corner outside the view
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
    DragSession m_session;      // session of Dragging, Slicing and m_nudging
    Dragging m_nudging;         // state of a held arrow key
    bool m_isPointRead = false; // true if the point reported last is still under the pointer
    std::optional<std::size_t> m_hovered;
    std::optional<std::size_t> m_focused;
    std::optional<std::size_t> m_face; // hovered or held face
    bool m_allowsNoAttractor = false;
    bool m_isEnabled = true;
};

} // namespace view
