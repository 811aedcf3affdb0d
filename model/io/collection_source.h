// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QFuture>
#include <QList>
#include <QString>
#include <QStringList>

namespace io {

// A file of a collection: its topic and its entries.
struct CollectionTheme {
    QString file; // name without the folder, such as ferns.ifs; independent of the language
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

// The title of an entry of the bundled files in the user's language; any other text as it is.
QString bundledTitle(const QString& title);

// Reads the bundled files, or those of a folder when one is named, in a thread of its own: a result for each,
// as soon as it is there, and the number of files as progress. Ends behind the present file when cancelled.
QFuture<CollectionTheme> readThemes(const QString& folder);

} // namespace io
