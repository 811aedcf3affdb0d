// SPDX-License-Identifier: MIT
#include "canvas/scene/canvas_cursors.h"

namespace view {

QCursor cursorFor(const CanvasPart& part, Holding holding) {
    const bool held = holding == Holding::Yes;
    switch (part.kind) {
    case CanvasPart::Kind::Vertex:
        return held ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
    case CanvasPart::Kind::Edge:
    case CanvasPart::Kind::Pivot:
        return held ? Qt::ClosedHandCursor : Qt::SizeAllCursor;
    case CanvasPart::Kind::Rotate:
        return held ? Qt::ClosedHandCursor : Qt::PointingHandCursor;
    case CanvasPart::Kind::Scale:
        return held ? Qt::ClosedHandCursor : Qt::SizeFDiagCursor;
    case CanvasPart::Kind::Inside:
    case CanvasPart::Kind::None:
        break;
    }
    return held ? Qt::ClosedHandCursor : Qt::CrossCursor;
}

} // namespace view
