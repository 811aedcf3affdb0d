// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QByteArray>

namespace io {

// Lines of Python that make the entry with the package barycage: its own text in a string, so that the cage,
// the colours and typed coefficients come along. docs/python.md.
QByteArray pythonText(const document::Fractal& fractal);

} // namespace io
