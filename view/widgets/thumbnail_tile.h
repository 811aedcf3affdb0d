// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/thumbnails.h"

#include <QPalette>
#include <QRect>

class QPainter;

namespace view {

// Draws the picture, or a quiet sign that says why there is none: an empty tile while it is being drawn, ∅
// without an attractor, a warning triangle for an unreadable entry.
void paintThumbnail(QPainter& painter, const QRect& area, const Thumbnail& thumbnail,
                    const QPalette& palette);

} // namespace view
