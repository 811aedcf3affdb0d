// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>

#include <map>
#include <optional>

namespace io {

// A PNG picture is complete when every chunk is there with the right checksum, from the header to the end,
// and nothing follows.
struct CheckedPng {
    std::optional<QString> damage; // why it is not complete, be it cut, damaged or not readable; a sentence
    bool isUnreadable = false;     // the system does not give its bytes
    // The uncompressed Latin-1 texts (tEXt) whose keywords begin with "barycage:"; none where it is damaged.
    std::map<QByteArray, QByteArray> texts;
    QSize size;              // as its header says, like the rest; none where it is damaged
    int bitsPerChannel = 0;  // up to 16
    bool hasOpacity = false; // of the pixels, not of the colours of a palette
};
CheckedPng checkedPng(const QString& path); // looks at no pixel

QSize pngSize(const QByteArray& bytes); // as the header of a PNG says; empty where there is none

// nullopt where the picture is not complete, or has no such text.
std::optional<QByteArray> textOfCompletePng(const QString& path, const QByteArray& keyword);

} // namespace io
