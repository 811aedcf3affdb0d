// SPDX-License-Identifier: MIT
#include "io/collection_source.h"

#include "io/file/background.h"
#include "io/file/save_file.h"
#include "io/fractint/fractint_reader.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

namespace io {
namespace {

// ./dev translate puts the texts of the bundled index, and the titles of the entries, into the catalogues.
QString translated(const QJsonValue& text) {
    return QCoreApplication::translate("Collection", text.toString().toUtf8().constData());
}

QString bundledFolder() {
    const QString resources = QStringLiteral(":/ifs_library");
    if (QFileInfo::exists(resources)) return resources;
    return QStandardPaths::locate(QStandardPaths::GenericDataLocation, QStringLiteral("barycage/ifs_library"),
                                  QStandardPaths::LocateDirectory);
}

QJsonArray themesIn(const QString& folder) {
    const QString index = folder + QStringLiteral("/index.json");
    if (!QFileInfo(index).isFile()) return {};
    return QJsonDocument::fromJson(loadFile(index).bytes).object().value(QLatin1String("themes")).toArray();
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
    theme.file = info.fileName();
    theme.title = info.completeBaseName();
    for (const QJsonValue& value : themesIn(info.path())) {
        const QJsonObject entry = value.toObject();
        if (entry.value(QLatin1String("file")).toString() != info.fileName()) continue;
        if (entry.contains(QLatin1String("title")))
            theme.title = translated(entry.value(QLatin1String("title")));
        theme.description = translated(entry.value(QLatin1String("description")));
    }
    const Loaded loaded = loadFile(path);
    if (loaded.failure)
        theme.description = *loaded.failure;
    else
        theme.entries = readFractint(loaded.bytes, info.completeBaseName()).entries;
    return theme;
}

QString bundledTitle(const QString& title) {
    return QCoreApplication::translate("CollectionNames", title.toUtf8().constData());
}

QFuture<CollectionTheme> readThemes(const QString& folder) {
    return inBackground<CollectionTheme>(Lane::Reading, [folder](QPromise<CollectionTheme>& themes) {
        const QStringList paths = folder.isEmpty() ? bundledCollection() : collectionIn(folder);
        const auto count = static_cast<int>(paths.size());
        themes.setProgressRange(0, count);
        for (int i = 0; i < count && !themes.isCanceled(); ++i) {
            themes.addResult(readTheme(paths[i]));
            themes.setProgressValue(i + 1);
        }
    });
}

} // namespace io
