// SPDX-License-Identifier: MIT
#pragma once

#include "io/report/info_report.h"

#include <QString>

namespace io {

// The report as people read it, six digits.
QString infoText(const InfoSubject& subject);

// A line for each entry: its number in the file, its dimension, how many maps it has, its name. Fast.
QString listText(const QList<document::Entry>& entries, const QList<qsizetype>& numbers);

} // namespace io
