// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/written_map.h"
#include "io/text/literal_lists.h"

#include <QList>

namespace io {

// Lists whose items all are maps; with `unread` where some are not understood.
QList<ListedMaps> mapsInLists(const Literal& root);

// Maps one after the other, each with a name of its own: A1 = [[…]], b1 = […], A2 = …
QList<ListedMaps> mapsInSequence(const Literal& root);

} // namespace io
