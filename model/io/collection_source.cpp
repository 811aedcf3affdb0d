// SPDX-License-Identifier: MIT
#include "io/collection_source.h"

#include "io/background.h"
#include "io/fractint_reader.h"
#include "io/save_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

namespace io {
namespace {

// What the index of the bundled collection says, for the translators; long sentences are in two parts.
// NOLINTBEGIN(bugprone-suspicious-missing-comma)
[[maybe_unused]] constexpr const char* indexTexts[] = {
    QT_TRANSLATE_NOOP("Collection", "From the paper"),
    QT_TRANSLATE_NOOP("Collection",
                      "The two systems of E. Hadzieva and M. Shuminoska, with the coefficients as printed."),
    QT_TRANSLATE_NOOP("Collection", "Ferns"),
    QT_TRANSLATE_NOOP("Collection", "Fronds: a long slow map climbs the rachis, two short ones hang the "
                                    "pinnae, a flat one draws the stem."),
    QT_TRANSLATE_NOOP("Collection", "Trees"),
    QT_TRANSLATE_NOOP("Collection", "Trunks that fork: the whole tree stands on its own branches."),
    QT_TRANSLATE_NOOP("Collection", "Dragons"),
    QT_TRANSLATE_NOOP("Collection",
                      "Folded paper curves and the fractals of two or three twisted similarities."),
    QT_TRANSLATE_NOOP("Collection", "Sierpiński family"),
    QT_TRANSLATE_NOOP("Collection",
                      "Gaskets and carpets: a polygon holds shrunken copies of itself and keeps its holes."),
    QT_TRANSLATE_NOOP("Collection", "Koch family"),
    QT_TRANSLATE_NOOP("Collection", "Curves built by replacing a segment, and the islands they bound."),
    QT_TRANSLATE_NOOP("Collection", "Spirals"),
    QT_TRANSLATE_NOOP("Collection",
                      "One map that turns and shrinks a little, and small ones that bead its path."),
    QT_TRANSLATE_NOOP("Collection", "Leaves and flowers"),
    QT_TRANSLATE_NOOP("Collection",
                      "Leaf outlines, and flowers whose petals are turned copies of one another."),
    QT_TRANSLATE_NOOP("Collection", "Tiles and reptiles"),
    QT_TRANSLATE_NOOP("Collection", "Sets that tile the plane: copies of themselves, rep-tiles, and the "
                                    "central tiles of number systems."),
    QT_TRANSLATE_NOOP("Collection", "Cantor sets and dust"),
    QT_TRANSLATE_NOOP("Collection",
                      "Sets full of gaps at every scale: points everywhere near, hardly any of them joined."),
    QT_TRANSLATE_NOOP("Collection", "Crystals and snowflakes"),
    QT_TRANSLATE_NOOP("Collection", "Sets with the symmetry of frost: five, six and more arms."),
    QT_TRANSLATE_NOOP("Collection", "Curves and graphs"),
    QT_TRANSLATE_NOOP("Collection",
                      "Graphs of strange functions, smooth curves as attractors, space-filling coordinates."),
    QT_TRANSLATE_NOOP("Collection", "Abstract"),
    QT_TRANSLATE_NOOP("Collection",
                      "Affine patterns without a name in nature: relatives of the gasket, weaves, rosettes."),
};
// NOLINTEND(bugprone-suspicious-missing-comma)

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

QFuture<CollectionTheme> readThemes(const QString& folder) {
    return inBackground<CollectionTheme>([folder](QPromise<CollectionTheme>& themes) {
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
