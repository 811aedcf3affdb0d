// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringView>

#include <charconv>
#include <optional>

// Numbers as text: always the C locale, whatever the user's.
namespace io {

// Like std::from_chars, but numbers closer to 0 than any double are 0, and only those that are too large are
// out of range.
std::from_chars_result fromChars(const char* first, const char* last, double& value,
                                 std::chars_format format = std::chars_format::general);

// A finite decimal number and nothing else (surrounding blanks allowed); nullopt for 1/3, 0,5, inf, nan, hex,
// "".
std::optional<double> parseNumber(QStringView text);

// The shortest text that reads back as the same double.
QByteArray formatNumber(double value);

} // namespace io
