// SPDX-License-Identifier: MIT
#pragma once

class QPoint;
class QWidget;

namespace view {

class Timeline;

// What can be done to the selected keys, their ease first, and to the current row. It opens there and deletes
// itself.
void showTrackMenu(Timeline& timeline, const QPoint& global, QWidget* parent);

} // namespace view
