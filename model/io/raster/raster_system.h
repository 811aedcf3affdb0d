// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/embedded_system.h"

#include <QByteArray>
#include <QString>

namespace io {

// Places in which the pictures of this folder's writers carry their system: comments of a JPEG and the
// ImageDescription of a TIFF, behind this mark, …
inline constexpr const char* systemMark = "Barycage\n";
// … in an attribute of that name of an OpenEXR picture, …
inline constexpr const char* exrSystemAttribute = "barycage";
// … and in an element `system` of this namespace in the XMP packet of a WebP.
QString xmpSystemNamespace();

// The kind of picture by its first bytes: "jpeg", "webp", "tiff" or "exr"; empty for any other.
QString rasterFormat(const QByteArray& bytes);

// The `.ifs` text embedded in such a picture. Reads no pixels, trusts no length and takes at most 8 MB; a
// damaged picture gives a failure.
EmbeddedSystem readRasterSystem(const QByteArray& bytes);

} // namespace io
