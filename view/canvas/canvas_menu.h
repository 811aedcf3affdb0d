// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/canvas_part.h"

#include <QPoint>

namespace document {
class Document;
}

namespace view {

class CanvasScene;
class CanvasView;

struct MenuContext {
    CanvasView& view;
    document::Document& document;
    CanvasScene& scene;
};

// The context menu of a handle, the cage or the empty canvas.
void popUpCanvasMenu(const MenuContext& context, const CanvasPart& part, const QPoint& global);

} // namespace view
