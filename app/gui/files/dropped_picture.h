// SPDX-License-Identifier: MIT
#pragma once

#include <QStringList>

class Panels;
class QMainWindow;
namespace view {
class CollagePanel;
}

// Makes a dropped file the target of a collage and shows the panel, if it is the only one and a picture and
// nothing more: its name is that of a picture, and it carries no system. False: it is to be opened. Reads
// the file in the background; events are handled meanwhile.
bool takeAsTarget(const QStringList& paths, QMainWindow& window, const Panels& panels,
                  view::CollagePanel& panel);
