// SPDX-License-Identifier: MIT
#pragma once

class QPoint;
class QWidget;

namespace view {

class Timeline;

// What can be done to the selected keys, their ease first, and to the current row. It opens there and deletes
// itself.
void showTrackMenu(Timeline& timeline, const QPoint& global, QWidget* parent);

// What Enter or a double click does to the current row: a key at the playhead of a track comes or goes, and
// the numbers of a motion are asked for.
void activateRow(Timeline& timeline, QWidget* parent);

} // namespace view
