// SPDX-License-Identifier: MIT
#pragma once

#include "io/picture/vector/svg_writer.h"

#include <QImage>

namespace io {

// The shapes of svgPicture() as a drawing program shows them, in the pixels of the camera, which may be fewer
// than those of the file: then as many copies as these pixels need. nullopt when stopped, and without shapes.
std::optional<QImage> shapePreview(const document::Fractal& fractal, const attractor::Camera& camera,
                                   const SvgFormat& format, const std::stop_token& stop = {});

} // namespace io
