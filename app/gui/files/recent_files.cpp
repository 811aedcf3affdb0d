// SPDX-License-Identifier: MIT
#include "files/recent_files.h"

#include "desktop/settings.h"
#include "io/file/slow_disk.h"

#include <QFileInfo>

namespace recent_files {

namespace {

constexpr int capacity = 12;

QString key() {
    return QStringLiteral("recentFiles");
}

} // namespace

QStringList list() {
    return io::withoutGone(view::stored(key()).toStringList());
}

void add(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList paths = list();
    paths.removeAll(absolute);
    paths.prepend(absolute);
    view::store(key(), paths.mid(0, capacity));
}

void clear() {
    view::store(key(), {});
}

} // namespace recent_files
