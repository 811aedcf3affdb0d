// SPDX-License-Identifier: MIT
#include "dialogs/export/export_camera.h"

#include <algorithm>

namespace view {

attractor::Camera resized(attractor::Camera camera, const QSize& size) {
    const double factor = std::min(double(size.width()) / std::max(1, camera.width),
                                   double(size.height()) / std::max(1, camera.height));
    camera.pixelsPerUnit *= factor;
    camera.width = size.width();
    camera.height = size.height();
    return camera;
}

} // namespace view
