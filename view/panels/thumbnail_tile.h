// SPDX-License-Identifier: MIT
#pragma once

#include "thumbnails.h"

#include <QPalette>
#include <QRect>

class QPainter;

namespace view {

// Draws the picture, or a quiet sign that says why there is none: an empty tile while it is being drawn, ∅
// without an attractor, a cube for an entry in space, a warning triangle for an unreadable one.
void paintThumbnail(QPainter& painter, const QRect& place, const Thumbnail& thumbnail,
                    const QPalette& palette);

} // namespace view
