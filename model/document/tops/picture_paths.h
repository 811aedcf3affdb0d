// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QString>

namespace document {

// The file as it is when it moves from one folder to another (absolute paths; `from` is empty while it has
// none): pictures of fractal transformations are still found. A path from the folder of the file leads there
// from the new one; a file that gets its first folder then has such paths in place of absolute ones. What
// does not change is shared with `file`.
FractalFile withPicturesFoundFrom(FractalFile file, const QString& from, const QString& to);

} // namespace document
