// SPDX-License-Identifier: MIT
#include "panels/collection_source.h"

#include "io/fractint_reader.h"
#include "io/save_file.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

namespace view {
namespace {

QString bundledFolder() {
    const QString resources = QStringLiteral(":/ifs_library");
    if (QFileInfo::exists(resources)) return resources;
    return QStandardPaths::locate(QStandardPaths::GenericDataLocation, QStringLiteral("barycage/ifs_library"),
                                  QStandardPaths::LocateDirectory);
}

QJsonArray themesIn(const QString& folder) {
    const QString index = folder + QStringLiteral("/index.json");
    if (!QFileInfo(index).isFile()) return {};
    return QJsonDocument::fromJson(io::loadFile(index).bytes)
        .object()
        .value(QLatin1String("themes"))
        .toArray();
}

} // namespace

QStringList bundledCollection() {
    const QString folder = bundledFolder();
    QStringList rest = collectionIn(folder);
    QStringList paths;
    for (const QJsonValue& theme : themesIn(folder)) {
        const QString path =
            folder + QLatin1Char('/') + theme.toObject().value(QLatin1String("file")).toString();
        if (rest.removeOne(path)) paths.append(path);
    }
    return paths + rest;
}

QStringList collectionIn(const QString& folder) {
    if (folder.isEmpty()) return {};
    QStringList paths;
    const QFileInfoList files = QDir(folder).entryInfoList(
        {QStringLiteral("*.ifs")}, QDir::Files | QDir::Readable, QDir::Name | QDir::IgnoreCase);
    for (const QFileInfo& file : files)
        paths.append(file.filePath());
    return paths;
}

CollectionTheme readTheme(const QString& path) {
    const QFileInfo info(path);
    CollectionTheme theme;
    theme.title = info.completeBaseName();
    for (const QJsonValue& value : themesIn(info.path())) {
        const QJsonObject entry = value.toObject();
        if (entry.value(QLatin1String("file")).toString() != info.fileName()) continue;
        theme.title = entry.value(QLatin1String("title")).toString(theme.title);
        theme.description = entry.value(QLatin1String("description")).toString();
    }
    const io::Loaded loaded = io::loadFile(path);
    if (loaded.failure)
        theme.description = *loaded.failure;
    else
        theme.entries = io::readFractint(loaded.bytes, info.completeBaseName()).entries;
    return theme;
}

} // namespace view
