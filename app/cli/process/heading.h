// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace cli {

// The heading of a sheet or a page about this file: "sierpinski.ifs" → "Sierpinski".
QString headingOf(const QString& fileName);

} // namespace cli
