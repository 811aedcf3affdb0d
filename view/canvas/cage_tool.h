// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/cage_drag.h"
#include "canvas/canvas_scene.h"
#include "canvas/canvas_tool.h"
#include "document/edit_gesture.h"

#include <QTimer>

#include <memory>

namespace view {

// Takes the cage by its vertices, edges, inside and handles, with the pointer and with the arrow keys.
class CageTool : public CanvasTool {
    Q_OBJECT

public:
    explicit CageTool(CanvasScene* scene);
    ~CageTool() override;

    void press(const Pointer& pointer) override;
    void move(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void leave() override;
    bool keyPress(const QKeyEvent& event) override;
    bool keyRelease(const QKeyEvent& event) override;
    bool cancel() override;
    bool isBusy() const override { return m_state != State::Idle; }
    void stop() override;
    QCursor cursor(const Pointer& pointer) const override;

    // The next or the previous handle, round and round: vertices, the whole cage, pivot, rotate, scale.
    void walk(int step);

signals:
    void grasped(); // a gesture has begun

private:
    enum class State {
        Idle,
        Pressed, // not yet moved far enough to mean a drag
        Dragging,
        MovingPivot,
        Nudging,  // an arrow key is held
        Cancelled // waits for the button to go up
    };

    void dragTo(const Pointer& pointer);
    void movePivot(const Pointer& pointer);
    void open(const CanvasPart& part, CageDrag::Mode mode, const QPointF& press);
    void turnInto(CageDrag::Mode mode);
    void restorePivot();
    void hover(const CanvasPart& part);
    void preview(const DragResult& result);
    void end();
    void nudge(const CanvasPart& part, const QPointF& direction, Qt::KeyboardModifiers modifiers);
    void keepNudging(quint64 stamp);
    ifs::ControlCage<2> nudged(const CanvasPart& part) const;

    CanvasScene* m_scene;
    State m_state = State::Idle;
    CanvasPart m_part;
    CageDrag m_drag;
    QPointF m_press;            // pixels
    attractor::Camera m_camera; // at the press
    ifs::Vector<2> m_pivotAtPress = ifs::Vector<2>::Zero();
    bool m_ownPivotAtPress = false;
    QPointF m_nudge;          // pixels, degrees or percent so far
    QTimer m_letGo;           // an arrow key has gone up, unless it only repeats
    quint64 m_letGoStamp = 0; // of that event
    std::unique_ptr<document::EditGesture> m_gesture;
};

} // namespace view
