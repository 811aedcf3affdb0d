// SPDX-License-Identifier: MIT
#pragma once

#include <QStringList>

// The last files opened or saved, newest first, kept between runs and shared by all windows.
namespace recent_files {

QStringList list(); // excludes files known to be gone; does not wait for slow drives
void add(const QString& path);
void clear();

} // namespace recent_files
