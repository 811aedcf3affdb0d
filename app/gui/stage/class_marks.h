// SPDX-License-Identifier: MIT
#pragma once

namespace view {
class CanvasView;
class Construction;
} // namespace view

// Puts over the picture what explains it to a class: the jumps of the chaos game, and the walk along the
// address of the branch that was clicked.
void addClassMarks(view::CanvasView& canvas, const view::Construction& construction);
