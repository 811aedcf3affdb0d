// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/embedded_system.h"

#include <QByteArray>
#include <QString>

namespace io {

// Where the pictures of this folder's writers carry their system: in comments of a JPEG and in
// ImageDescription of a TIFF behind this mark, …
inline constexpr const char* systemMark = "Barycage\n";
// … in an attribute of that name of an OpenEXR picture, …
inline constexpr const char* exrSystemAttribute = "barycage";
// … and in an element `system` of this namespace in the XMP packet of a WebP.
QString xmpSystemNamespace();

// What the first bytes say: "jpeg", "webp", "tiff" or "exr", or nothing if it is none of them.
QString rasterFormat(const QByteArray& bytes);

// The `.ifs` text embedded in such a picture. Reads no pixels, trusts no length and takes at most 8 MB; a
// damaged picture gives a failure.
EmbeddedSystem readRasterSystem(const QByteArray& bytes);

} // namespace io
