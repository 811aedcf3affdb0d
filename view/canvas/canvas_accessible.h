// SPDX-License-Identifier: MIT
#pragma once

class QGraphicsView;

namespace view {

// Lets screen readers see a view of a CanvasScene with its handles as children: names, positions and focus.
void installCanvasAccessibility();
void announceFocus(QGraphicsView& view);  // another handle has the focus
void announceMotion(QGraphicsView& view); // the handle in focus is elsewhere

} // namespace view
