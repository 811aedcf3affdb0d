// SPDX-License-Identifier: MIT
#pragma once

class QPoint;
class QWidget;

namespace view {

class Timeline;

// A menu for the selected keys, their ease first, and for the current row. It opens there and deletes itself.
void showTrackMenu(Timeline& timeline, const QPoint& global, QWidget* parent);

// The effect of Enter or a double click on the current row: toggles a track's key at the playhead, or asks
// for the numbers of a motion.
void activateRow(Timeline& timeline, QWidget* parent);

} // namespace view
