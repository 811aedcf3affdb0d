// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

class QWidget;

// Whether a dropped file is a picture and nothing more, so that it can only be the target of a collage: its
// name is that of one, and a PNG picture carries no system. Reads a PNG in the background; events are handled
// meanwhile.
bool isPlainPicture(const QString& path, QWidget* window);
