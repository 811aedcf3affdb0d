// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/camera.h"
#include "document/document.h"

#include <QImage>
#include <QRectF>

class QPainter;
class QWidget;

namespace view {

// Shows a print preview of the page below, and prints it from there.
void printFractal(document::Document* document, const attractor::Camera& camera, QWidget* parent);

// Name, picture and table of coefficients, from the top of `page` down.
void paintPage(QPainter& painter, const QRectF& page, const document::Fractal& fractal,
               const QImage& picture);

} // namespace view
