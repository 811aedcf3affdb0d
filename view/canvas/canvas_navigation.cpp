// SPDX-License-Identifier: MIT
#include "canvas/canvas_navigation.h"

#include "bridges/render_bridge.h"
#include "canvas/geometry/canvas_geometry.h"
#include "document/moments/animated_fractal.h"
#include "io/file/background.h"

#include <QWidget>

#include <chrono>
#include <numbers>
#include <utility>

namespace view {

namespace {

constexpr double unitPixels = 100; // pixels per unit of the plane at 100 %
constexpr double fitMargin = 0.09;
// Least size of the attractor in a fit with the cage, as a share of its size alone.
constexpr double minShare = 0.5;
// The same share for a fit with a single corner, if the cage would take too much.
constexpr double minCorner = 0.8;
constexpr std::chrono::milliseconds fitPatience{12};

document::Box with(document::Box box, const std::vector<ifs::Vector<2>>& points) {
    for (const ifs::Vector<2>& point : points)
        box = document::united(box, {point, point});
    return box;
}

std::optional<document::Box> boxAround(const std::vector<ifs::Vector<2>>& points) {
    if (points.empty()) return std::nullopt;
    return with({points.front(), points.front()}, points);
}

// A cage and its picture that were near each other before it was dragged belong together, however flat they
// are now. False where nothing was dragged.
bool isUndraggedCageNear(const document::Fractal& fractal, const attractor::Camera& camera) {
    const ifs::ControlCage<2>* cage = document::cage2(fractal);
    if (!cage || cage->current == cage->rest) return false;
    if (document::system2(fractal)->maps.size() >= manyMaps) return false; // a second box may take long
    document::Fractal undragged = fractal;
    document::plane(undragged)->cage->current = cage->rest;
    const auto alone = document::displayedBox(undragged);
    if (!alone) return false;
    const auto scale = [&camera](const document::Box& box) {
        return attractor::fitted(camera, box.min, box.max, fitMargin).pixelsPerUnit;
    };
    return scale(with(*alone, cage->rest)) >= minShare * scale(*alone);
}

} // namespace

CanvasNavigation::CanvasNavigation(CanvasScene& scene, RenderBridge& bridge, const QWidget& viewport)
    : m_scene(scene), m_bridge(bridge), m_viewport(viewport) {
    connect(&m_extent, &QFutureWatcherBase::finished, this, [this] {
        if (m_isFitted && m_extent.future().resultCount() > 0) takeExtent(m_extent.result());
    });
}

void CanvasNavigation::setCamera(const attractor::Camera& camera) {
    const double ratio = m_viewport.devicePixelRatioF();
    const attractor::Camera shown = withinDepth(camera);
    m_scene.setView(shown, ratio);
    if (shown.width > 0 && shown.height > 0) m_bridge.setCamera(deviceCamera(shown, ratio));
    emit cameraChanged();
}

void CanvasNavigation::moveTo(const attractor::Camera& camera) {
    m_isFitted = false;
    setCamera(camera);
}

void CanvasNavigation::adoptViewport() {
    attractor::Camera adopted = camera();
    adopted.width = m_viewport.width();
    adopted.height = m_viewport.height();
    setCamera(adopted);
    if (m_isFitted) fitAgain();
}

void CanvasNavigation::fit() {
    m_corners = Corners::Near;
    fitAgain();
}

void CanvasNavigation::fitCorners() {
    m_corners = Corners::All;
    fitAgain();
}

bool CanvasNavigation::fitsMotion() const {
    return document::animationFacts(m_scene.document().entryFractal()).has_value();
}

void CanvasNavigation::fitAgain() {
    using Extent = document::MotionExtent;
    m_isFitted = true;
    m_extent.future().cancel();
    m_extent.setFuture({});
    const document::Document& document = m_scene.document();
    if (!document::system2(document.fractal())) return fitTo({});
    const bool moves = fitsMotion();
    const auto fractal = moves ? document.currentEntry().fractal : document.sharedFractal();
    if (moves && fractal == m_moving) return fitTo(m_motion);
    m_sought = moves ? fractal : nullptr;
    const QFuture<Extent> extent =
        io::inBackground<Extent>([fractal, moves, yAxis = m_scene.camera().yAxis](QPromise<Extent>& promise) {
            promise.addResult(moves ? document::motionExtent(
                                          *fractal, [&] { return promise.isCanceled(); }, yAxis)
                                    : Extent{document::boxWithShadow(*fractal, yAxis), {}});
        });
    if (io::finishesWithin(fitPatience, extent) && extent.resultCount() > 0) // usually known already
        takeExtent(extent.result());
    else
        m_extent.setFuture(extent);
}

void CanvasNavigation::takeExtent(document::MotionExtent extent) {
    if (m_sought) {
        m_moving = std::exchange(m_sought, nullptr);
        m_motion = extent;
    }
    fitTo(extent);
}

void CanvasNavigation::fitTo(const document::MotionExtent& extent) {
    std::vector<ifs::Vector<2>> corners = extent.corners;
    // No further corners: those of an entry at rest, or of one that stores no cage, never move.
    if (const auto& cage = m_scene.handles().cage(); corners.empty() && cage) corners = cage->current;
    std::optional<document::Box> attractor = extent.picture;
    if (m_fittedToo) attractor = attractor ? document::united(*attractor, *m_fittedToo) : m_fittedToo;
    std::optional<document::Box> all = attractor ? with(*attractor, corners) : boxAround(corners);
    if (!all) all = document::Box{ifs::Vector<2>(-1, -1), ifs::Vector<2>(1, 1)};
    const auto fitted = [this](const document::Box& box) {
        return attractor::fitted(camera(), box.min, box.max, fitMargin);
    };
    if (m_corners == Corners::All) {
        const std::vector<ifs::Vector<2>> held = m_scene.handles().heldPoints(); // of the selected maps
        all = with(*all, held);
    }
    if (!attractor || m_corners == Corners::All ||
        isUndraggedCageNear(m_scene.document().fractal(), camera()))
        return setCamera(fitted(*all));
    const double alone = fitted(*attractor).pixelsPerUnit;
    if (fitted(*all).pixelsPerUnit < minShare * alone) {
        all = attractor;
        for (const ifs::Vector<2>& vertex : corners)
            if (fitted(with(*attractor, {vertex})).pixelsPerUnit >= minCorner * alone)
                all = with(*all, {vertex});
    }
    setCamera(fitted(*all));
}

void CanvasNavigation::zoomAt(const QPointF& position, double factor) {
    moveTo(attractor::zoomedAt(camera(), toVector(position), factor));
    emit zoomed(position);
}

void CanvasNavigation::zoomBy(double factor) {
    zoomAt(middle(), factor);
}

QPointF CanvasNavigation::middle() const {
    return {m_viewport.width() / 2.0, m_viewport.height() / 2.0};
}

double CanvasNavigation::zoom() const {
    return camera().pixelsPerUnit / unitPixels;
}

void CanvasNavigation::setZoom(double factor) {
    attractor::Camera zoomed = camera();
    zoomed.pixelsPerUnit = factor * unitPixels;
    moveTo(zoomed);
}

void CanvasNavigation::resetZoom() {
    setZoom(1);
}

void CanvasNavigation::pan(const QPointF& pixels) {
    moveTo(attractor::panned(camera(), toVector(pixels)));
}

void CanvasNavigation::setYAxis(attractor::YAxis yAxis) {
    attractor::Camera turned = camera();
    turned.yAxis = yAxis;
    setCamera(turned);
}

void CanvasNavigation::rotateAt(const QPointF& position, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    moveTo(attractor::rotatedAt(camera(), toVector(position), angle));
    emit zoomed(position);
}

void CanvasNavigation::rotateBy(double degrees) {
    rotateAt(middle(), degrees);
}

double CanvasNavigation::rotation() const {
    return attractor::degreesOf(camera().rotation);
}

void CanvasNavigation::resetRotation() {
    rotateBy(-rotation());
}

} // namespace view
