// SPDX-License-Identifier: MIT
#include "document/tops/picture_paths.h"

#include "document/tops/kept_theft.h"

#include <QDir>

#include <memory>

namespace document {

namespace {

QString moved(const QString& picture, const QString& from, const QString& to) {
    const bool isAbsolute = QDir::isAbsolutePath(picture);
    if (isAbsolute != from.isEmpty()) return picture; // stored that way by the user, or without a target
    return QDir(to).relativeFilePath(isAbsolute ? picture : QDir(from).filePath(picture));
}

} // namespace

FractalFile withPicturesFoundFrom(FractalFile file, const QString& from, const QString& to) {
    // Lexical comparison without the disk.
    if (!from.isEmpty() && QDir::cleanPath(from) == QDir::cleanPath(to)) return file;
    for (qsizetype i = 0; i < file.entries.size(); ++i) {
        const Fractal& fractal = *file.entries.at(i).fractal;
        std::optional<KeptTheft> theft = keptTheft(fractal);
        if (!theft || theft->picture.isEmpty()) continue;
        const QString picture = moved(theft->picture, from, to);
        if (picture == theft->picture) continue;
        theft->picture = picture;
        file.entries[i].fractal = std::make_shared<const Fractal>(withTheft(fractal, theft));
    }
    return file;
}

} // namespace document
