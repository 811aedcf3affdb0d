// SPDX-License-Identifier: MIT
#pragma once

#include "io/overlay/overlay_marks.h"

#include <QByteArray>

namespace io {

// The operators of a page whose unit is a pixel, y down, that draw the marks.
QByteArray pdfMarks(const OverlayMarks& marks);
// What the dictionary of its resources must hold for them, without its brackets.
QByteArray pdfMarkResources(const OverlayMarks& marks);

} // namespace io
