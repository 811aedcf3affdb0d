// SPDX-License-Identifier: MIT
#pragma once

#include <QStringList>

// The last files opened or saved, newest first, kept between runs and shared by all windows.
namespace recent_files {

QStringList list(); // without those that are known to be gone; a slow drive is not waited for
void add(const QString& path);
void clear();

} // namespace recent_files
