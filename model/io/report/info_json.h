// SPDX-License-Identifier: MIT
#pragma once

#include "io/report/info_report.h"

#include <QByteArray>

namespace io {

// A JSON object with all facts; null for those that are not known. docs: the manual page of barycage-cli.
QByteArray infoJson(const InfoSubject& subject);

// The same with no more of each entry than its number in the file, name, dimension and number of maps. At
// once.
QByteArray listJson(const InfoSubject& subject, const QList<qsizetype>& numbers);

// docs/info.schema.json: what all of these are.
QByteArray infoSchema();

} // namespace io
