// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "document/document.h"

#include <QImage>
#include <QWidget>

namespace view {

// Puts the picture on the clipboard: `shown` as pixels, and the same view as SVG, which is written in the
// background while `parent` shows its progress. Where the user cancels that, only the pixels are copied.
void copyPicture(document::Document* document, const attractor::Camera& camera, const QImage& shown,
                 QWidget* parent = nullptr);

} // namespace view
