// SPDX-License-Identifier: MIT
#pragma once

#include "io/overlay/overlay_marks.h"

#include <QByteArray>

namespace io {

// The operators of a page whose unit is a pixel, y down, that draw the marks.
QByteArray pdfMarks(const OverlayMarks& marks);
// Entries that the resource dictionary of the page must hold for the marks, without its brackets.
QByteArray pdfMarkResources(const OverlayMarks& marks);

} // namespace io
