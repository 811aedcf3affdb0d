// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace io {

// Returns true if a path named in a file leads from the file's folder to a place below it, through any
// symbolic links. A path that leads elsewhere must not be read unless the user agrees: a file from a stranger
// could name any other file.
bool liesInside(const QString& folder, const QString& path);

} // namespace io
