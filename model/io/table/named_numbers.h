// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/markup_table.h"

#include <QList>
#include <QString>

namespace io {

// Maps whose numbers each stand behind their name, as "r = 0.5, theta = 90°, e = 1, f = 0" or "a1=.5 b1=0 …",
// on a line or on several: a header, and a row for each map. Empty unless there are at least two maps, all
// with the same names, which say everything.
QList<MarkupRow> namedNumbers(const QString& text);

} // namespace io
