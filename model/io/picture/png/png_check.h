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
    std::optional<QString> damage; // reason why it is incomplete, damaged or unreadable, as a sentence
    bool isUnreadable = false;     // true if the system cannot read its bytes
    // The uncompressed Latin-1 texts (tEXt) whose keywords begin with "barycage:"; none where it is damaged.
    std::map<QByteArray, QByteArray> texts;
    QSize size;              // size in the header, like what follows; empty if damaged
    int bitsPerChannel = 0;  // at most 16
    bool hasOpacity = false; // opacity of pixels, not of palette colours
};
CheckedPng checkedPng(const QString& path); // checks no pixels

QSize pngSize(const QByteArray& bytes); // size in the header of a PNG; empty if there is none

// nullopt where the picture is not complete, or has no such text.
std::optional<QByteArray> textOfCompletePng(const QString& path, const QByteArray& keyword);

} // namespace io
