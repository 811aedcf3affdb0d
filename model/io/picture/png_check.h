// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace io {

// The uncompressed Latin-1 text (tEXt) with this keyword in a PNG picture that is complete: every chunk is
// there with the right checksum, from the header to the end, and nothing follows. nullopt of anything else,
// be it cut, damaged, without such a text, or not readable. Looks at no pixel.
std::optional<QByteArray> textOfCompletePng(const QString& path, const QByteArray& keyword);

// Why the file is no complete PNG picture, as a sentence; nullopt: it is one, with or without texts.
std::optional<QString> pngDamage(const QString& path);

} // namespace io
