// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace io {

// Whether a path that a file names leads from the folder of the file to a place below it, through any
// symbolic links. A path that leads elsewhere may not be read unless the user agrees: a file from a stranger
// could name any other file.
bool liesInside(const QString& folder, const QString& path);

} // namespace io
