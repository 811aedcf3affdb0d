// SPDX-License-Identifier: MIT
#pragma once

#include "io/overlay/overlay_marks.h"

class QXmlStreamWriter;

namespace io {

// Writes an element for each mark into the element that is open.
void writeSvgMarks(QXmlStreamWriter& xml, const OverlayMarks& marks);

} // namespace io
