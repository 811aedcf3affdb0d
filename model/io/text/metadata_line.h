// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"

#include <QByteArray>
#include <QByteArrayList>

#include <optional>
#include <string>
#include <vector>

// The form of the lines "; barycage: key values". docs/formats.md, "Barycage's comment lines".
namespace io {

inline constexpr const char* metadataPrefix = "barycage:";
inline constexpr qsizetype maxMetadataLine = 69; // bytes

QByteArray metadataLine(const char* key, const QByteArray& values);
// The values on as many lines with this key as they need; at least one.
QByteArrayList metadataLines(const char* key, const QByteArrayList& values);

// Values and lines as model/notation has them.
std::vector<std::string> plainWords(const QByteArrayList& values);
QByteArrayList byteLines(const std::vector<std::string>& lines);

// A value of such a line.
std::optional<double> metadataNumber(const QByteArray& value);

// A text that is written after this key: one line, no blanks at its ends, short enough.
std::string storableText(const char* key, const std::string& text);

} // namespace io
