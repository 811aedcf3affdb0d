// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "document/fractal/fractal.h"

#include <QImage>

namespace io {

enum class CageVisibility { Hidden, Shown };

// Draws the control polygon with its numbered corners over a picture of the fractal, as the canvas has it:
// where it is, without the rest polygon, which PictureOverlay::cage shows. `rows` holds the rows of the
// picture from `firstRow` on.
// `background` is what it is painted on.
void paintCage(QImage& rows, const document::Fractal& fractal, const attractor::Camera& camera,
               const attractor::Rgba& background, int firstRow = 0);

} // namespace io
