// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>

namespace cli {

// Translates a sentence of the command line, which scripts read in English.
inline QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

} // namespace cli
