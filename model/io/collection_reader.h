// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"
#include "io/exchange/flame.h"
#include "io/table/table_columns.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace io {

// Content of a file of any kind that can be opened. Only a Fractint collection may be written back in place.
struct Collection {
    QString format; // one of collectionFormats()
    document::FractalFile file;
    bool isOrderAssumed = false; // true for a table that does not name its columns
};

// The names of the formats that are told apart, and "unknown".
QStringList collectionFormats();

// Choices for what a format leaves open.
struct ReadOptions {
    FlameAxis axis = FlameAxis::Flipped;
    // Columns of a table; nullopt: by its header, else in Fractint's order.
    std::optional<TableColumns> columns;
};

// Tells the format from the content: a Fractint collection, flames, IFStile's blocks, a table of numbers,
// lists of maps in another language, a link, or a picture that carries a collection. For any other file, the
// problems say what it seems to be. `path` names the entry of a table or of a file of bare rows.
Collection readCollection(const QByteArray& bytes, const QString& path = {}, const ReadOptions& options = {});

} // namespace io
