// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/camera.h"
#include "document/fractal.h"

#include <QColor>
#include <QImage>

namespace io {

enum class CageVisibility { Hidden, Shown };

QColor cageColour();

// Draws the control polygon over a picture of the fractal, the rest polygon dashed where it differs.
void paintCage(QImage& picture, const document::Fractal& fractal, const attractor::Camera& camera);

} // namespace io
