// SPDX-License-Identifier: MIT
#include "dialogs/export/last_export.h"

#include "desktop/settings.h"
#include "document/text/file_names.h"

#include <QDir>
#include <QFileInfo>

namespace view {

namespace {

QString key(const QString& kind, const char* what) {
    return QStringLiteral("export/%1/%2").arg(kind, QLatin1String(what));
}

} // namespace

LastExport lastExport(const QString& kind) {
    return {stored(key(kind, "format")).toString(), stored(key(kind, "size")).toString(),
            stored(key(kind, "more")).toString()};
}

void rememberExport(const QString& kind, const LastExport& last, const QString& path) {
    store(key(kind, "format"), last.format);
    store(key(kind, "size"), last.size);
    if (!last.more.isEmpty()) store(key(kind, "more"), last.more);
    store(key(kind, "folder"), QFileInfo(path).absolutePath());
}

QString suggestedPath(const QString& kind, const QString& name, const QString& otherwise) {
    const QString last = stored(key(kind, "folder")).toString();
    const QString folder = last.isEmpty() ? otherwise : last;
    const QString file = document::fileNamePart(name);
    return folder.isEmpty() ? file : QDir(folder).filePath(file);
}

} // namespace view
