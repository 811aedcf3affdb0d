// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/pixel_version.h"
#include "io/picture/plane_export.h"
#include "io/picture/space_export.h"

#include <QByteArray>

#include <optional>

namespace io {

// Text of everything that determines the pixels of a picture of Algorithm::Density: the entry, the view, the
// size, the seed, the format and the version of the pixels, not the number of samples and nothing that
// changes no byte. Equal pictures have equal texts.
QByteArray pictureRequest(const PlaneExport& picture, int pixels = attractor::pixelVersion);

// The picture again, its samples 0; nullopt where the text is none, or of another version of the pixels.
std::optional<PlaneExport> pictureOf(const QByteArray& request);

// The same of a picture in space, one eye's: of a cloud or a solid.
QByteArray pictureRequest(const SpaceExport& picture, int pixels = attractor::pixelVersion);
std::optional<SpaceExport> spacePictureOf(const QByteArray& request);
bool isOfSpace(const QByteArray& request);

} // namespace io
