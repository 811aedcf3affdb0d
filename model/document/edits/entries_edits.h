// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QList>
#include <QString>

#include <optional>

// Edits of the list of entries: a file in, a file out. No byte of the entries that stay is touched, and the
// text above a file's first entry stays at the top of the file whatever becomes of that entry.
namespace document {

struct Inserted {
    FractalFile file;
    QList<EntryId> ids; // ids of the new entries, in their order
};
// Inserts behind the entry `after` (None: at the end), under fresh ids and, where they are readable, unique
// names.
Inserted inserted(FractalFile file, const QList<Entry>& entries, EntryId after);

FractalFile removed(FractalFile file, const QList<EntryId>& ids);

// Moves the entries, in the order of the file, together in front of the entry `before` (None: at the end).
// When `before` is one of them, they gather where it stands.
FractalFile moved(FractalFile file, const QList<EntryId>& ids, EntryId before);

FractalFile replaced(FractalFile file, EntryId id, Fractal fractal);

// Flips the plane systems among those entries: y becomes −y.
FractalFile turnedOver(FractalFile file, const QList<EntryId>& ids);

// Why the entry cannot be called `name`, as a sentence for the user; nullopt when it can.
std::optional<QString> nameProblem(const FractalFile& file, EntryId id, const QString& name);

} // namespace document
