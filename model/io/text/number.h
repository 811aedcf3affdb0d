// SPDX-License-Identifier: MIT
#pragma once

#include "notation/text/number.h"

#include <QByteArray>
#include <QString>
#include <QStringView>

#include <optional>

// Numbers as text: always the C locale, whatever the user's.
namespace io {

using notation::fromChars;

// A finite decimal number and nothing else (surrounding blanks allowed); nullopt for 1/3, 0,5, inf, nan, hex,
// "".
std::optional<double> parseNumber(QStringView text);

// The shortest text that reads back as the same double.
QByteArray formatNumber(double value);

} // namespace io
