// SPDX-License-Identifier: MIT
#pragma once

class QGraphicsView;

namespace view {

// Lets screen readers see a view of a CanvasScene with its handles as children: names, positions and focus.
void installCanvasAccessibility();
void announceFocus(QGraphicsView& view);  // for a change of the handle with the focus
void announceMotion(QGraphicsView& view); // for a motion of the handle with the focus

} // namespace view
