// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/embedded_system.h"

#include <QByteArray>
#include <QString>

namespace io {

// The namespace of the element that holds the text.
QString svgSystemNamespace();

bool looksLikeSvg(const QByteArray& bytes);

// The `.ifs` text that svgPicture() embedded. Refuses document type declarations, so that no entity is ever
// expanded, and texts of more than 8 MB.
EmbeddedSystem readSvgSystem(const QByteArray& bytes);

} // namespace io
