// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"
#include "document/tops/kept_theft.h"

namespace document {

enum class TheftFamily { Triangle, Square };

struct StartedTheft {
    FractalFile file;
    EntryId from = EntryId::None; // entry that keeps the transformation
};
// The file with two more entries at the end, the member of the family with all parameters ½ and another one,
// which the first keeps as its partner.
StartedTheft withStarter(const FractalFile& file, TheftFamily family);

// A partner for an entry that keeps none: the first other one of the plane with as many active maps, else the
// first other one of the plane. None: there is none.
EntryId likelyPartner(const FractalFile& file, EntryId of);
// The entry of that name; None where there is none.
EntryId entryNamed(const FractalFile& file, const QString& name);

// Divides words of both entries until they have equally many maps; returns the file as it is where that is
// not possible.
FractalFile withWordsDivided(const FractalFile& file, EntryId from, EntryId to);

} // namespace document
