// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/entries_edits.h"

#include <QString>

// Fractal transformations name their partner; here the names follow what happens to it.
namespace document {

// The file in which entry `id` is called `name`, and the transformations that have it as their partner say
// so. No entry may have that name already.
FractalFile renamed(const FractalFile& file, EntryId id, const QString& name);

// Inserts like inserted(); if a new entry and its partner are both inserted, they stay partners whatever they
// are called now.
Inserted insertedTogether(FractalFile file, const QList<Entry>& entries, EntryId after);

// The picture of the transformation, whose path is relative to `folder`, by a path that is valid wherever the
// entry goes.
Fractal withPictureFrom(Fractal fractal, const QString& folder);

} // namespace document
