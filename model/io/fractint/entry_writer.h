// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QByteArray>

namespace io {

// An entry in the strict form that every reader takes; used for new entries and for the clipboard.
QByteArray writeEntry(const document::Fractal& fractal, const QByteArray& lineEnd = "\n");

} // namespace io
