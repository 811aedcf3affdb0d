// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QByteArray>

namespace io {

// IFStile's text, as far as it holds affine systems: blocks "@id:" of the plane or of space, whose maps are
// "f1=[e,f]*[a,b,c,d]" and whose last line is "A=(f1|f2)*A". A block that says more is an entry without a
// system, with an error that names the first line that is not understood. Weights are those of a comment
// "# weights: …", as writeAifs() has it.
document::FractalFile readAifs(const QByteArray& bytes);

bool looksLikeAifs(const QByteArray& bytes); // true if the first significant line is "@id:" or a setting

} // namespace io
