// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace io {

// Number of other names (hard links) of the file to which `path` leads through symbolic links; 0 for a new
// file and for anything that is not a regular file. Saving makes another file of the same name: the other
// names keep leading to the old contents, which may be intended, as in a backup.
int otherNames(const QString& path);

} // namespace io
