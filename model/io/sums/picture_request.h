// SPDX-License-Identifier: MIT
#pragma once

#include "io/picture/png_export.h"

#include <QByteArray>

#include <optional>

namespace io {

// What decides the pixels of a picture of Algorithm::Density, as text: the entry, the view, the size, the
// seed and the format, not the number of samples and nothing that changes no byte. Equal pictures have equal
// texts.
QByteArray pictureRequest(const PngExport& picture);

// The picture again, its samples 0; nullopt where the text is none.
std::optional<PngExport> pictureOf(const QByteArray& request);

} // namespace io
