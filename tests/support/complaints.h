// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QString>

// What must hold of every document, however it came about.
namespace support {

// A sentence about what should never be; empty when all is well.
using Complaint = QString;

// Numbers that are not finite, cages that cannot be.
Complaint complaintAbout(const document::Fractal& fractal);

// A file that is not what is read when it has been written. `bareName` names an entry without a name.
Complaint complaintAbout(const document::FractalFile& file, const QString& bareName);

} // namespace support
