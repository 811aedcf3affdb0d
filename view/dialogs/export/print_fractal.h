// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/request/orbit_camera.h"
#include "document/document.h"

#include "dialogs/export/print_preview.h"

#include <QImage>
#include <QRectF>

#include <functional>

class QPainter;
class QWidget;

namespace view {

// Shows a print preview of the page below, and prints it from there: showPrintPreview().
void printFractal(document::Document* document, const attractor::Camera& camera, QWidget* parent,
                  const PrintSaid& said);
void printFractal(document::Document* document, const attractor::OrbitCamera& camera, QWidget* parent,
                  const PrintSaid& said);

// Name, comments, picture and table of coefficients, in space also that of the cage's corners, from the top
// of `page` down. What does not fit legibly goes on the pages after it: `newPage` begins one.
void paintPages(QPainter& painter, const QRectF& page, const document::Fractal& fractal,
                const QImage& picture, const std::function<void()>& newPage);

} // namespace view
