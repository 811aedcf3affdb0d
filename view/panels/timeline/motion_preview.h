// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <QColor>
#include <QPixmap>

#include <vector>

namespace view {

// Whether the entry has few enough maps for moving pictures.
bool isPreviewed(const document::Fractal& entry);

// A few points of an animated entry at one frame after the other, as small pictures: the same points in all
// of them, so that they move. `ink` draws them, unless the palette itself moves. Empty where the entry does
// not move, or has so many maps that this would take long.
struct PreviewStyle {
    QSize size; // logical pixels
    double pixelRatio = 1;
    QColor ink;
};
std::vector<QPixmap> motionPreview(const document::Fractal& entry, const PreviewStyle& style);

constexpr int previewFrames = 24; // of a preview

} // namespace view
