// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"

#include <QSize>

namespace view {

// The same view in another size: the visible part stays in the picture, and where the shape differs, more is
// shown around it.
attractor::Camera resized(attractor::Camera camera, const QSize& size);

} // namespace view
