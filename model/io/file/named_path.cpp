// SPDX-License-Identifier: MIT
#include "io/file/named_path.h"

#include <QDir>
#include <QFileInfo>

namespace io {

bool liesInside(const QString& folder, const QString& path) {
    const QString from = QDir::cleanPath(path);
    if (QDir::isAbsolutePath(from) || from == u".." || from.startsWith(QStringLiteral("../"))) return false;
    const QString end = QFileInfo(QDir(folder), from).canonicalFilePath();
    if (end.isEmpty()) return true; // nothing to read
    QString inside = QFileInfo(folder).canonicalFilePath();
    if (!inside.endsWith(u'/')) inside += u'/';
    return end.startsWith(inside);
}

} // namespace io
