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
    void dragStarted(); // sent at the beginning of a gesture

protected:
    // Points moved by a drag of a part.
    struct DragSubject {
        QString text; // text of the undo step
        std::vector<ifs::Vector<2>> points;
        std::vector<int> vertices; // indices of the points that move
    };
    virtual std::optional<DragSubject> dragSubject(const CanvasPart& part,
                                                   PolygonDrag::Mode mode) = 0; // nullopt: cannot be dragged
    struct Shown {
        double share = 1; // share of the requested change
        DragResult result;
    };
    // Shows the result of the gesture so far. resultAt(1) is the requested one, resultAt(0) the beginning.
    // Each call computes; the result shown is requested once.
    virtual Shown preview(const std::function<DragResult(double)>& resultAt) = 0;
    // Called for a press that may become a drag.
    virtual void pressed(const CanvasPart&, Qt::KeyboardModifiers) {}
    virtual void clicked(const CanvasPart&, const Pointer&) {} // called for a press and release in place
    virtual void abandoned() {} // called after an undo within a gesture, before ended()
    virtual void ended() {}     // called at the end of a gesture

    // Selectable items of the polygons, by numbers of the tool's own: by a rectangle drawn from the empty
    // canvas, and by clicks. nullopt if nothing can be selected.
    virtual std::optional<std::vector<std::size_t>> selectedItems() const { return std::nullopt; }
    virtual void selectItems(const std::vector<std::size_t>&) {}
    virtual std::vector<std::size_t> enclosedBy(const QRectF&) const { return {}; } // pixels
    // Delete, Insert and the like, while nothing is held.
    bool isBareKey(const QKeyEvent& event, Qt::Key key) const;
    // Selects the item alone, or adds or removes it.
    void selectClicked(std::size_t item, Qt::KeyboardModifiers modifiers);

    static constexpr Qt::KeyboardModifiers adding =
        Qt::ControlModifier | Qt::ShiftModifier; // modifiers that add to the selection

    CanvasScene& scene() const { return m_scene; }
    CanvasSelection& selection() const { return m_scene.selection(); }
    HandleModel& handles() const { return m_scene.handles(); }
    document::EditGesture& gesture() { return m_session.gesture(); }
    const document::EditGesture& gesture() const { return m_session.gesture(); }
    const PolygonDrag& drag() const { return m_drag; }

private:
    enum class State {
        Idle,
        Pressed, // not yet moved far enough for a drag
        Dragging,
        MovingPivot,
        Selecting, // selection by a rectangle
        Nudging,   // arrow key held
        Cancelled  // waiting for the release of the button
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
    QPointF m_pointer;          // pixels, in a drag
    attractor::Camera m_camera; // camera at the press
    ifs::Vector<2> m_pivotAtPress = ifs::Vector<2>::Zero();
    bool m_ownPivotAtPress = false;
    std::vector<std::size_t> m_selectionAtPress;
    QPointF m_nudge; // sum in pixels, degrees or percent
    DragSession m_session;
};

} // namespace view
