// SPDX-License-Identifier: MIT
#pragma once

namespace view {

class CanvasView;

// Lets screen readers see the canvas with its handles as children: their names, places and focus.
void installCanvasAccessibility();
void announceFocus(CanvasView& canvas);  // another handle has the focus
void announceMotion(CanvasView& canvas); // the handle in focus is elsewhere

} // namespace view
