// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace io {

// How many other names (hard links) the file has that `path` leads to through symbolic links; 0 for a new
// file and for what is no ordinary file. A file that is saved becomes another file of the same name: the
// other names go on leading to the old contents, which may be what they are for, as in a backup.
int otherNames(const QString& path);

} // namespace io
