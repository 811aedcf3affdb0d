// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/barycentric.h"
#include "space/slice_item.h"
#include "space/space_cage_item.h"
#include "space/space_navigation.h"
#include "space/spatial_drag.h"

#include <QKeyEvent>
#include <QMetaType>
#include <QMouseEvent>
#include <QWheelEvent>

#include <optional>
#include <variant>

namespace view {

// What is under the pointer in space.
struct SpacePosition {
    ifs::Vector<3> world = ifs::Vector<3>::Zero();
    double depth = 0;         // along the view away from the eye, 0 in the plane of the target
    double unitsPerPixel = 1; // in the plane of the target
    bool onAttractor = false; // else in the plane of the target
    // With respect to the current tetrahedron; nullopt while it is flat.
    std::optional<ifs::Barycentric<3>> barycentric;
    AxisLock lock; // of the corner that is dragged
};

// What mouse and keyboard do in the window into space: orbit, pan, and drag vertices. One gesture at a time.
class SpaceInput : public QObject {
    Q_OBJECT

public:
    SpaceInput(document::Document* document, SpaceNavigation& navigation, SpaceCageItem& cage,
               SliceItem& slice, AxisBall& ball);

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void handleDoubleClick(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    void leave();
    bool needsKey(const QKeyEvent& event) const; // more than the shortcuts of the window
    bool keyPress(const QKeyEvent& event);       // false when it means nothing here
    void keyRelease(const QKeyEvent& event);
    bool cancelGesture();          // false when none was under way
    bool focusVertex(bool next);   // the next or previous one; false past the last
    void forgetFocus();            // of another fractal
    void setEnabled(bool enabled); // handles and ball can be held

    std::optional<std::size_t> focusedVertex() const { return m_focused; }
    void showMarks(bool hasFocus); // on the items, as things are
    Qt::CursorShape cursor() const;

signals:
    void changed(); // marks or cursor
    void pointerMoved(const view::SpacePosition& position);
    void pointerLeft();
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
    struct Dragging {
        document::EditGesture gesture;
        SpatialDrag drag;
        Pull pull;
        AxisLock lock;
        bool isLockedByShift = false;
    };

    bool isIdle() const { return std::holds_alternative<std::monostate>(m_gesture); }
    void beginOrbit(const QMouseEvent& event, std::optional<AxisBall::End> end);
    void beginDrag(std::size_t vertex, const QMouseEvent& event);
    void follow(Orbiting& orbiting, const QPointF& position);
    void follow(Dragging& dragging, const QMouseEvent& event);
    void follow(Slicing& slicing, const QPointF& position);
    bool isOnSlice(const QPointF& position) const;
    void preview(Dragging& dragging);
    void report(const Dragging& dragging);
    void nudge(const QPointF& pixels);
    bool lockBy(const QKeyEvent& event);
    bool viewBy(const QKeyEvent& event);
    void report(const QPointF& position);

    document::Document* m_document;
    SpaceNavigation& m_navigation;
    SpaceCageItem& m_cage;
    SliceItem& m_slice;
    AxisBall& m_ball;
    std::variant<std::monostate, Orbiting, Panning, Dragging, Slicing> m_gesture;
    QPointF m_pointer;
    std::optional<std::size_t> m_hovered;
    std::optional<std::size_t> m_focused;
    bool m_isEnabled = true;
    bool m_isSpaceHeld = false;
};

} // namespace view

Q_DECLARE_METATYPE(view::SpacePosition)
