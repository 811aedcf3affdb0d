// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"
#include "io/table/table_reader.h"

#include <QByteArray>
#include <QList>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <vector>

class QMimeData;

// Entries on their way through the clipboard and drag and drop, as the text of an .ifs file.
namespace view {

// The entries one after the other: readable ones in the form every reader takes, unreadable ones as they were
// read.
QByteArray entriesText(const QList<document::Entry>& entries);
std::unique_ptr<QMimeData> entriesMimeData(const QList<document::Entry>& entries);

// Entries found in a text: an .ifs file or part of one, flames, or a bare table of numbers. Readable entries
// carry no source, so that they are written anew; the ids mean nothing.
struct FoundEntries {
    QList<document::Entry> entries;
    document::Problems problems{}; // problems of the text and of its entries
    // The text, when it is a table that does not say what its columns are: its entry is in the order of
    // Fractint, and the user is to be asked.
    QString table{};
    bool areFlames = false;
};
FoundEntries entriesIn(const QByteArray& text); // thread-safe
// Result may be called in any thread at any time.
std::function<QByteArray()> entriesTextIn(const QMimeData& mimeData);
FoundEntries entriesIn(const QMimeData& mimeData);

// Rows of maps likewise, as a table; those copied in this process are there as they were.
struct CopiedMaps {
    std::vector<ifs::WeightedMap<2>> plane;
    std::vector<ifs::WeightedMap<3>> space; // empty if `plane` is not, and vice versa
    QStringList names;                      // one for each map; empty: none
};
std::unique_ptr<QMimeData> mapsMimeData(CopiedMaps maps);
const CopiedMaps* ourMaps(const QMimeData& mimeData); // nullptr: not copied by this process
bool holdsOurMaps(const QMimeData& mimeData);         // true for maps of any process, whose columns are known
struct FoundMaps {
    io::Table table;
    bool isOrderOpen = false; // true if the text does not name its columns
    QString text;             // text of the table, if the order is open
};
FoundMaps mapsIn(const QString& text, bool areOurs); // thread-safe

bool holdsText(const QMimeData& mimeData);      // false for blanks only
bool mayHoldEntries(const QMimeData& mimeData); // fast check for enabling actions and accepting a drag

} // namespace view
