// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/problem.h"

#include <QByteArray>
#include <QList>

#include <cstdint>
#include <memory>

namespace document {

enum class EntryId : std::uint32_t { None = 0 };

// The bytes from which an entry was read, and their meaning. Never changes: while the entry's fractal still
// equals `fractal`, it is written back byte for byte.
struct EntrySource {
    QByteArray before; // bytes between the previous entry and this one
    QByteArray
        text; // from the name to the closing brace and the rest of that line where it belongs to the entry
    Fractal fractal;
    int line = 1;              // line of the name, 1-based
    QByteArray lineEnd = "\n"; // end of new lines
};

struct Entry {
    EntryId id = EntryId::None;
    std::shared_ptr<const Fractal> fractal;    // never null; shared by the steps of the history
    std::shared_ptr<const EntrySource> source; // null for new entries
    Problems problems;                         // problems of reading

    friend bool operator==(const Entry& a, const Entry& b);
};

// An ordered file of entries: a plain value, cheap to copy.
struct FractalFile {
    QByteArray
        // Head of the file before the comments of the first entry: byte order mark, title; always stays
        // first.
        head;
    QList<Entry> entries;
    QByteArray tail; // bytes after the last entry: comments, ^Z
    QByteArray lineEnd = "\n";
    Problems problems; // problems of the file as a whole

    friend bool operator==(const FractalFile&, const FractalFile&);
};

EntryId freshId(const FractalFile& file);
qsizetype indexOf(const FractalFile& file, EntryId id); // −1 if absent
// `name` made legal and unique in the file, ignoring case: at most 18 bytes, no blanks, parentheses, braces,
// ; or :. The entry `except` (the one being renamed) does not count as a holder of the name.
QString uniqueName(const FractalFile& file, const QString& name, EntryId except = EntryId::None);

FractalFile fileOf(Fractal fractal); // new file of one entry

} // namespace document
