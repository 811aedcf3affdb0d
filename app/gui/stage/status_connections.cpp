// SPDX-License-Identifier: MIT
#include "stage/status_connections.h"

#include "bridges/render_bridge.h"
#include "bridges/solid_bridge.h"
#include "stage/stage.h"
#include "stage/status_line.h"

void connectStatus(StatusLine* line, Stage* stage, const view::RenderBridge* plane,
                   const view::SolidBridge* solid) {
    view::CanvasView* canvas = stage->plane();
    const view::SpaceView* space = stage->space();
    const auto showRotation = [line, stage, canvas] {
        line->showRotation(stage->showsSpace() ? 0 : canvas->navigation().rotation());
    };
    QObject::connect(&canvas->navigation(), &view::CanvasNavigation::cameraChanged, line, showRotation);
    QObject::connect(stage, &Stage::switched, line, showRotation);
    QObject::connect(canvas, &view::CanvasView::pointerMoved, line, &StatusLine::showPointer);
    QObject::connect(canvas, &view::CanvasView::pointerLeft, line, &StatusLine::clearPointer);
    QObject::connect(space, &view::SpaceView::pointerMoved, line, &StatusLine::showSpacePointer);
    QObject::connect(space, &view::SpaceView::pointerLeft, line, &StatusLine::clearPointer);
    QObject::connect(solid, &view::SolidBridge::frameChanged, line, [line, solid] {
        if (solid->frame()) line->showTime(solid->frame()->milliseconds);
    });
    QObject::connect(plane, &view::RenderBridge::frameChanged, line, [line, plane] {
        if (plane->frame()) line->showFrame(*plane->frame());
    });
}
