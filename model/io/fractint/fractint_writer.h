// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QByteArray>

namespace io {

// The file with every untouched entry byte for byte as it was read. Of an edited entry only the edited rows
// and our own comment lines change.
QByteArray writeFractint(const document::FractalFile& file);

} // namespace io
