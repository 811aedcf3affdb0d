// SPDX-License-Identifier: MIT
#pragma once

#include <QLockFile>
#include <QString>

#include <memory>

namespace document {

// Files that belong to the process that made them for as long as it lives, and to whoever comes first after
// that: windows and processes at the same time never use the same one.

// The lock of such a file, which lies beside it, for as long as it lives; nullptr while another process, or
// another lock of this one, has it.
std::unique_ptr<QLockFile> processLock(const QString& path);
QString lockFileOf(const QString& path);

// Creates the folder when it is missing; nobody but its owner may enter it.
void makePrivateFolder(const QString& folder);

} // namespace document
