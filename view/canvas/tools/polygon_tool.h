// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/geometry/polygon_drag.h"
#include "canvas/scene/canvas_scene.h"
#include "canvas/tools/canvas_tool.h"
#include "gestures/drag_session.h"

#include <functional>
#include <optional>

namespace view {

// Drags polygons by their vertices, edges, inside and handles, with the pointer and with the arrow keys. What
// the polygons are, and what moving them does to the fractal, is for the tools made from this.
class PolygonTool : public CanvasTool {
    Q_OBJECT

public:
    explicit PolygonTool(CanvasScene& scene);
    ~PolygonTool() override;

    void press(const Pointer& pointer) override;
    void move(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void leave() override;
    bool keyPress(const QKeyEvent& event) override;
    bool keyRelease(const QKeyEvent& event) override { return m_session.releaseRun(event); }
    bool cancel() override;
    bool isBusy() const override { return m_state != State::Idle; }
    void stop() override;
    QCursor cursor(const Pointer& pointer) const override;

    // Moves the focus to the next or the previous handle; false beyond the last one, where none is in focus.
    virtual bool walk(int step);

signals:
    void dragStarted(); // a gesture has begun

protected:
    // Points moved by a drag of a part.
    struct DragSubject {
        QString text; // of the undo step
        std::vector<ifs::Vector<2>> points;
        std::vector<int> vertices; // those of the points that move
    };
    virtual std::optional<DragSubject> dragSubject(const CanvasPart& part,
                                                   PolygonDrag::Mode mode) = 0; // nullopt: it stays
    struct Shown {
        double share = 1; // of what is asked for
        DragResult result;
    };
    // Shows the result of the gesture so far. resultAt(1) is the requested one, resultAt(0) the beginning.
    // Each call computes; the result shown is requested once.
    virtual Shown preview(const std::function<DragResult(double)>& resultAt) = 0;
    virtual void pressed(const CanvasPart&, Qt::KeyboardModifiers) {} // perhaps to be dragged
    virtual void clicked(const CanvasPart&, const Pointer&) {}        // pressed and let go where it was
    virtual void abandoned() {} // undone in the middle; ended() comes next
    virtual void ended() {}     // nothing is held any more

    // Selectable items of the polygons, by numbers of the tool's own: by a rectangle drawn from the empty
    // canvas, and by clicks. nullopt if nothing can be selected.
    virtual std::optional<std::vector<std::size_t>> selectedItems() const { return std::nullopt; }
    virtual void selectItems(const std::vector<std::size_t>&) {}
    virtual std::vector<std::size_t> enclosedBy(const QRectF&) const { return {}; } // pixels
    // Delete, Insert and the like, while nothing is held.
    bool isBareKey(const QKeyEvent& event, Qt::Key key) const;
    void selectClicked(std::size_t item, Qt::KeyboardModifiers modifiers); // alone, or one more or less

    static constexpr Qt::KeyboardModifiers adding =
        Qt::ControlModifier | Qt::ShiftModifier; // to the selection

    CanvasScene& scene() const { return m_scene; }
    CanvasSelection& selection() const { return m_scene.selection(); }
    HandleModel& handles() const { return m_scene.handles(); }
    document::EditGesture& gesture() { return m_session.gesture(); }
    const document::EditGesture& gesture() const { return m_session.gesture(); }
    const PolygonDrag& drag() const { return m_drag; }

private:
    enum class State {
        Idle,
        Pressed, // not yet moved far enough to mean a drag
        Dragging,
        MovingPivot,
        Selecting, // by a rectangle
        Nudging,   // an arrow key is held
        Cancelled  // waits for the button to go up
    };

    void dragTo(const Pointer& pointer);
    void movePivot(const Pointer& pointer);
    void selectWithin(const Pointer& pointer);
    bool open(const CanvasPart& part, PolygonDrag::Mode mode, const QPointF& press);
    void turnInto(PolygonDrag::Mode mode);
    void restorePivot();
    void hover(const CanvasPart& part);
    double show(const std::function<DragResult(double)>& resultAt);
    void describe(const DragResult& result);
    void settle();
    void end();
    void nudge(const CanvasPart& part, const QPointF& direction, Qt::KeyboardModifiers modifiers);
    DragResult nudged(const QPointF& by) const;

    CanvasScene& m_scene;
    State m_state = State::Idle;
    CanvasPart m_part;
    PolygonDrag m_drag;
    QPointF m_pointer;          // pixels, of a drag
    attractor::Camera m_camera; // at the press
    ifs::Vector<2> m_pivotAtPress = ifs::Vector<2>::Zero();
    bool m_ownPivotAtPress = false;
    std::vector<std::size_t> m_selectionAtPress;
    QPointF m_nudge; // pixels, degrees or percent so far
    DragSession m_session;
};

} // namespace view
