// SPDX-License-Identifier: MIT
#pragma once

class QWidget;

namespace view {

// Lets the names of all number fields in `root`, the labels whose buddies they are, be dragged left and right
// to change the number: a step every few pixels, a tenth of it with Shift, ten times as much with Ctrl. The
// whole drag is one edit; Esc takes it back.
void makeNamesDraggable(QWidget* root);

} // namespace view
