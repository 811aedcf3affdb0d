// SPDX-License-Identifier: MIT
#include "attractor/request/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace attractor {

namespace {

double down(const Camera& camera) {
    return camera.yAxis == YAxis::Up ? -1 : 1;
}

ifs::Vector<2> middle(const Camera& camera) {
    return {camera.width / 2.0, camera.height / 2.0};
}

// A camera that is not turned computes as if there were no rotation.
ifs::Vector<2> turned(const Camera& camera, const ifs::Vector<2>& pixels) {
    return camera.rotation == 0 ? pixels : ifs::Vector<2>(screenTurn(camera.rotation) * pixels);
}
ifs::Vector<2> turnedBack(const Camera& camera, const ifs::Vector<2>& pixels) {
    return camera.rotation == 0 ? pixels : ifs::Vector<2>(screenTurn(-camera.rotation) * pixels);
}

double wrapped(double degrees) {
    constexpr double digits = 1e6;
    const double angle = std::round(std::remainder(degrees, 360) * digits) / digits;
    return angle <= -180 ? angle + 360 : angle;
}

} // namespace

Camera cameraOf(const View& view, RasterSize size) {
    return {view.centre, size.height / view.height, size.width, size.height, view.yAxis, view.rotation};
}

View viewOf(const Camera& camera) {
    return {camera.centre, camera.height / camera.pixelsPerUnit, camera.yAxis, camera.rotation};
}

double rotationOf(double degrees) {
    return wrapped(degrees) * std::numbers::pi / 180;
}

double degreesOf(double rotation) {
    return wrapped(rotation * 180 / std::numbers::pi);
}

ifs::Matrix<2> screenTurn(double rotation) {
    constexpr double exact = 1e-12;
    int quarters = 0;
    double rest = std::remquo(rotation, std::numbers::pi / 2, &quarters);
    if (std::abs(rest) < exact) rest = 0;
    double cosine = std::cos(rest), sine = std::sin(rest);
    for (int k = 0; k < (quarters & 3); ++k)
        cosine = std::exchange(sine, cosine) * -1;
    ifs::Matrix<2> turn;
    turn << cosine, sine, -sine, cosine;
    return turn;
}

ifs::AffineMap<2> worldToPixel(const Camera& camera) {
    ifs::AffineMap<2> map;
    map.linear << camera.pixelsPerUnit, 0, 0, down(camera) * camera.pixelsPerUnit;
    if (camera.rotation != 0) map.linear = (screenTurn(camera.rotation) * map.linear).eval();
    map.translation = middle(camera) - map.linear * camera.centre;
    return map;
}

ifs::Vector<2> toPixel(const Camera& camera, const ifs::Vector<2>& world) {
    const ifs::Vector<2> offset = (world - camera.centre) * camera.pixelsPerUnit;
    return middle(camera) + turned(camera, {offset.x(), down(camera) * offset.y()});
}

ifs::Vector<2> toWorld(const Camera& camera, const ifs::Vector<2>& pixel) {
    const ifs::Vector<2> offset = turnedBack(camera, pixel - middle(camera)) / camera.pixelsPerUnit;
    return camera.centre + ifs::Vector<2>(offset.x(), down(camera) * offset.y());
}

Camera fitted(Camera camera, const ifs::Vector<2>& min, const ifs::Vector<2>& max, double margin) {
    ifs::Vector<2> extent = max - min;
    camera.centre = (min + max) / 2;
    // Single point up to rounding: magnified, it would lie outside the picture.
    if (!(extent.maxCoeff() > 1e-12 * camera.centre.cwiseAbs().maxCoeff())) return camera;
    if (camera.rotation != 0) extent = (screenTurn(camera.rotation).cwiseAbs() * extent).eval();
    const double room = 1 - 2 * margin;
    const double across = extent.x() > 0 ? room * camera.width / extent.x() : HUGE_VAL;
    const double along = extent.y() > 0 ? room * camera.height / extent.y() : HUGE_VAL;
    const double scale = std::min(across, along);
    if (std::isfinite(scale) && scale > 0) camera.pixelsPerUnit = scale;
    return camera;
}

Camera zoomedAt(Camera camera, const ifs::Vector<2>& pixel, double factor) {
    const ifs::Vector<2> offset = turnedBack(camera, pixel - middle(camera)) / camera.pixelsPerUnit;
    const ifs::Vector<2> shift = offset * (1 - 1 / factor);
    camera.centre += ifs::Vector<2>(shift.x(), down(camera) * shift.y());
    camera.pixelsPerUnit *= factor;
    return camera;
}

Camera rotatedAt(Camera camera, const ifs::Vector<2>& pixel, double angle) {
    const ifs::Vector<2> before = turnedBack(camera, pixel - middle(camera)) / camera.pixelsPerUnit;
    camera.rotation = rotationOf(degreesOf(camera.rotation) + angle * 180 / std::numbers::pi);
    const ifs::Vector<2> after = turnedBack(camera, pixel - middle(camera)) / camera.pixelsPerUnit;
    const ifs::Vector<2> shift = before - after;
    camera.centre += ifs::Vector<2>(shift.x(), down(camera) * shift.y());
    return camera;
}

Camera panned(Camera camera, const ifs::Vector<2>& delta) {
    const ifs::Vector<2> shift = turnedBack(camera, delta) / camera.pixelsPerUnit;
    camera.centre -= ifs::Vector<2>(shift.x(), down(camera) * shift.y());
    return camera;
}

} // namespace attractor
