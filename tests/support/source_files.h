// SPDX-License-Identifier: MIT
#pragma once

#include "support/paths.h"

#include <QDirIterator>
#include <QStringList>

namespace support {

// The paths of all files below these folders of the source tree whose names match a pattern.
inline QStringList sourceFiles(const QStringList& folders, const QStringList& names) {
    QStringList files;
    for (const QString& folder : folders) {
        QDirIterator it(sourcePath(folder), names, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext())
            files << it.next();
    }
    return files;
}

} // namespace support
