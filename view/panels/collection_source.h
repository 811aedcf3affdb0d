// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QList>
#include <QString>
#include <QStringList>

namespace view {

// One file of a collection: what it is about, and its entries.
struct CollectionTheme {
    QString title;
    QString description;
    QList<document::Entry> entries;
};

// The paths of the bundled files, theme by theme in the order of their index; files the index does not name
// come last. From the program's resources, or from where it was installed.
QStringList bundledCollection();

// The .ifs files of a folder, by name.
QStringList collectionIn(const QString& folder);

// Title and description come from the index beside the file if there is one, else from the file's name.
CollectionTheme readTheme(const QString& path);

} // namespace view
