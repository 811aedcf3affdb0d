// SPDX-License-Identifier: MIT
#include "recent_files.h"

#include "settings.h"

#include <QFileInfo>

namespace recent_files {

namespace {

constexpr int capacity = 12;

QString key() {
    return QStringLiteral("recentFiles");
}

} // namespace

QStringList list() {
    QStringList paths = view::stored(key()).toStringList();
    paths.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
    return paths;
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
