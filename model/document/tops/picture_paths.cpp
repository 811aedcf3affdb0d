// SPDX-License-Identifier: MIT
#include "document/tops/picture_paths.h"

#include "document/tops/kept_theft.h"

#include <QDir>

#include <memory>

namespace document {

namespace {

QString moved(const QString& picture, const QString& from, const QString& to) {
    const bool isAbsolute = QDir::isAbsolutePath(picture);
    if (isAbsolute != from.isEmpty()) return picture; // somebody has written it so, or it leads nowhere
    return QDir(to).relativeFilePath(isAbsolute ? picture : QDir(from).filePath(picture));
}

} // namespace

FractalFile withPicturesFoundFrom(FractalFile file, const QString& from, const QString& to) {
    if (!from.isEmpty() && QDir(from) == QDir(to)) return file;
    for (Entry& entry : file.entries) {
        std::optional<KeptTheft> theft = keptTheft(*entry.fractal);
        if (!theft || theft->picture.isEmpty()) continue;
        const QString picture = moved(theft->picture, from, to);
        if (picture == theft->picture) continue;
        theft->picture = picture;
        entry.fractal = std::make_shared<const Fractal>(withTheft(*entry.fractal, theft));
    }
    return file;
}

} // namespace document
