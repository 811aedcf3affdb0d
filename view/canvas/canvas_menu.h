// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/canvas_navigation.h"
#include "canvas/tools/toolbox.h"

#include <functional>

class QAbstractScrollArea;

namespace view {

struct MenuContext {
    QAbstractScrollArea& view;
    CanvasScene& scene;
    Toolbox& tools;
    CanvasNavigation& navigation;
    CanvasOptions& options;
    std::function<void()> copyPicture;
};

// The context menu of a handle, the cage or the empty canvas.
void popUpCanvasMenu(const MenuContext& context, const CanvasPart& part, const QPoint& global);

} // namespace view
