// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace cli {

// What a sheet or a page of this file is called: "sierpinski.ifs" → "Sierpinski".
QString headingOf(const QString& fileName);

} // namespace cli
