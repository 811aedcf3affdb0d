// SPDX-License-Identifier: MIT
#include "attractor/request/camera.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

double down(const Camera& camera) {
    return camera.yAxis == YAxis::Up ? -1 : 1;
}

ifs::Vector<2> middle(const Camera& camera) {
    return {camera.width / 2.0, camera.height / 2.0};
}

} // namespace

Camera cameraOf(const View& view, RasterSize size) {
    return {view.centre, size.height / view.height, size.width, size.height, view.yAxis};
}

ifs::AffineMap<2> worldToPixel(const Camera& camera) {
    ifs::AffineMap<2> map;
    map.linear << camera.pixelsPerUnit, 0, 0, down(camera) * camera.pixelsPerUnit;
    map.translation = middle(camera) - map.linear * camera.centre;
    return map;
}

ifs::Vector<2> toPixel(const Camera& camera, const ifs::Vector<2>& world) {
    const ifs::Vector<2> offset = (world - camera.centre) * camera.pixelsPerUnit;
    return middle(camera) + ifs::Vector<2>(offset.x(), down(camera) * offset.y());
}

ifs::Vector<2> toWorld(const Camera& camera, const ifs::Vector<2>& pixel) {
    const ifs::Vector<2> offset = (pixel - middle(camera)) / camera.pixelsPerUnit;
    return camera.centre + ifs::Vector<2>(offset.x(), down(camera) * offset.y());
}

Camera fitted(Camera camera, const ifs::Vector<2>& min, const ifs::Vector<2>& max, double margin) {
    const ifs::Vector<2> extent = max - min;
    camera.centre = (min + max) / 2;
    // A point, but for rounding: magnified, it would lie outside the picture.
    if (!(extent.maxCoeff() > 1e-12 * camera.centre.cwiseAbs().maxCoeff())) return camera;
    const double room = 1 - 2 * margin;
    const double across = extent.x() > 0 ? room * camera.width / extent.x() : HUGE_VAL;
    const double along = extent.y() > 0 ? room * camera.height / extent.y() : HUGE_VAL;
    const double scale = std::min(across, along);
    if (std::isfinite(scale) && scale > 0) camera.pixelsPerUnit = scale;
    return camera;
}

Camera zoomedAt(Camera camera, const ifs::Vector<2>& pixel, double factor) {
    const ifs::Vector<2> offset = (pixel - middle(camera)) / camera.pixelsPerUnit;
    const ifs::Vector<2> shift = offset * (1 - 1 / factor);
    camera.centre += ifs::Vector<2>(shift.x(), down(camera) * shift.y());
    camera.pixelsPerUnit *= factor;
    return camera;
}

Camera panned(Camera camera, const ifs::Vector<2>& delta) {
    const ifs::Vector<2> shift = delta / camera.pixelsPerUnit;
    camera.centre -= ifs::Vector<2>(shift.x(), down(camera) * shift.y());
    return camera;
}

} // namespace attractor
