// SPDX-License-Identifier: MIT
#include "space/space_navigation.h"

#include "canvas/geometry/canvas_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"
#include "document/moments/motion_extent.h"
#include "io/file/background.h"

#include <chrono>
#include <cmath>
#include <utility>

namespace view {

namespace {

constexpr double fitMargin = 0.09;
constexpr double unitPixels = 100; // pixels of a unit at 100 %
constexpr int glideTime = 200;     // milliseconds
constexpr std::chrono::milliseconds fitPatience{12};
constexpr attractor::Direction fromTheSide{30, 20};

} // namespace

SpaceNavigation::SpaceNavigation(document::Document* document, SolidBridge* bridge, const QWidget* viewport)
    : m_document(document),
      m_bridge(bridge),
      m_viewport(viewport),
      m_camera(attractor::turnedTo({}, fromTheSide.azimuth, fromTheSide.elevation)) {
    m_glide.setDuration(glideTime);
    m_glide.setEasingCurve(QEasingCurve::InOutCubic);
    m_glide.setStartValue(0.0);
    m_glide.setEndValue(1.0);
    connect(&m_corners, &QFutureWatcherBase::finished, this, [this] {
        if (!m_sought || m_corners.future().resultCount() == 0) return;
        takeMotion(m_corners.result());
        if (m_isFitted && m_document->currentEntry().fractal == m_moving && !m_motion.empty()) fitMotion();
    });
}

void SpaceNavigation::set(const attractor::OrbitCamera& camera, bool isMoving) {
    m_camera = camera;
    attractor::OrbitCamera device = camera;
    device.size.width = int(std::lround(camera.size.width * pixelRatio()));
    device.size.height = int(std::lround(camera.size.height * pixelRatio()));
    if (attractor::isUsable(device)) m_bridge->setCamera(device, isMoving);
    emit changed();
}

void SpaceNavigation::moveTo(const attractor::OrbitCamera& camera, bool isMoving) {
    m_glide.stop();
    m_isFitted = false;
    const bool isOtherProjection = camera.projection != m_camera.projection;
    set(camera, isMoving);
    if (!isOtherProjection) return;
    choosePerspective(isPerspective());
    emit perspectiveChanged(isPerspective());
}

void SpaceNavigation::followKeys(attractor::OrbitCamera camera, bool isMoving) {
    camera.size = m_camera.size;
    choosePerspective(camera.projection == attractor::OrbitCamera::Projection::Perspective);
    moveTo(camera, isMoving);
}

// A view that jumps is not recognised.
void SpaceNavigation::glideTo(const attractor::OrbitCamera& camera) {
    m_glide.stop();
    m_glide.disconnect(this);
    m_isFitted = false;
    connect(&m_glide, &QVariantAnimation::valueChanged, this,
            [this, from = m_camera, to = camera](const QVariant& value) {
                const double t = value.toDouble();
                attractor::OrbitCamera between = to;
                between.size = m_camera.size;
                if (t < 1) {
                    between.target = from.target + t * (to.target - from.target);
                    between.orientation = from.orientation.slerp(t, to.orientation).normalized();
                    between.height = from.height * std::pow(to.height / from.height, t);
                }
                set(between, t < 1);
            });
    m_glide.start();
}

void SpaceNavigation::adoptViewport() {
    attractor::OrbitCamera adopted = m_camera;
    adopted.size.width = m_viewport->width() / picturesAcross(m_stereo);
    adopted.size.height = m_viewport->height();
    set(adopted, false);
    if (m_isFitted) fitAgain();
}

void SpaceNavigation::fit() {
    m_fitted = m_document->moment();
    fitAgain();
}

// Fits an animation as a whole, as soon as its extent is known.
void SpaceNavigation::fitAgain() {
    if (m_camera.size.width <= 0 || m_camera.size.height <= 0) return;
    m_glide.stop();
    m_isFitted = true;
    const auto entry = m_document->currentEntry().fractal;
    if (document::space(*entry) && document::animationFacts(*entry)) {
        if (entry != m_moving) seekMotion(entry);
        if (entry == m_moving && !m_motion.empty()) return fitMotion();
    }
    const auto fitTo = [this](const document::Fractal& fractal) {
        if (document::isSpaceExtentKnown(fractal))
            set(document::fittedTo(fractal, m_camera, fitMargin), false);
    };
    if (m_document->moment() == m_fitted) return fitTo(m_document->fractal());
    document::Fractal fractal = document::frameAt(m_document->entryFractal(), m_fitted).fractal;
    fractal.lasting = m_document->fractal().lasting;
    fitTo(fractal);
}

void SpaceNavigation::seekMotion(const std::shared_ptr<const document::Fractal>& entry) {
    using Corners = std::vector<ifs::Vector<3>>;
    if (entry == m_sought) return;
    m_corners.future().cancel();
    m_sought = entry;
    const QFuture<Corners> corners = io::inBackground<Corners>([entry](QPromise<Corners>& promise) {
        promise.addResult(document::motionCorners(*entry, [&] { return promise.isCanceled(); }));
    });
    m_corners.setFuture(corners);
    if (io::finishesWithin(fitPatience, corners) && corners.resultCount() > 0) takeMotion(corners.result());
}

void SpaceNavigation::takeMotion(std::vector<ifs::Vector<3>> corners) {
    m_moving = std::exchange(m_sought, nullptr);
    m_motion = std::move(corners);
}

void SpaceNavigation::fitMotion() {
    set(attractor::fitted(m_camera, document::reachOfVertices(m_motion), fitMargin), false);
}

void SpaceNavigation::zoomAt(const QPointF& position, double factor) {
    moveTo(attractor::zoomedAt(m_camera, toVector(inEye(position)), factor));
}

void SpaceNavigation::resetZoom() {
    attractor::OrbitCamera reset = m_camera;
    reset.height = m_camera.size.height / unitPixels;
    glideTo(reset);
}

void SpaceNavigation::orbit(const attractor::OrbitCamera& before, const ifs::Vector<3>& pivot, double right,
                            double up, bool isMoving) {
    moveTo(m_isTrackball ? attractor::tumbled(before, pivot, right, up)
                         : attractor::orbited(before, pivot, right, up, m_up),
           isMoving);
}

// Turns the scene with the fingers, as it is seen from above; from below, the other way.
void SpaceNavigation::twistAt(const QPointF& position, double degrees) {
    if (m_isFixed) return;
    leaveAxisView();
    const bool isFromBelow = attractor::directionOf(m_camera, m_up).elevation < 0;
    orbit(m_camera, pointUnder(position).value_or(pivotBeside()), isFromBelow ? -degrees : degrees, 0);
}

void SpaceNavigation::setStereo(attractor::Stereo stereo) {
    if (stereo == m_stereo) return;
    m_glide.stop();
    m_stereo = stereo;
    m_bridge->setStereo(stereo);
    adoptViewport();
    emit stereoChanged();
}

QPointF SpaceNavigation::inEye(const QPointF& position) const {
    const bool isRight = picturesAcross(m_stereo) > 1 && position.x() >= m_camera.size.width;
    return isRight ? position - QPointF(m_camera.size.width, 0) : position;
}

void SpaceNavigation::setTrackball(bool on) {
    if (on == m_isTrackball) return;
    m_isTrackball = on;
    if (on) return;
    const auto [azimuth, elevation] = attractor::directionOf(m_camera, m_up);
    const attractor::OrbitCamera level = attractor::turnedTo(m_camera, azimuth, elevation, m_up);
    if (level.orientation.angularDistance(m_camera.orientation) > 1e-9) glideTo(level);
}

void SpaceNavigation::setUpAxis(attractor::UpAxis up) {
    if (up == m_up) return;
    m_glide.stop();
    set(attractor::stoodUp(m_camera, std::exchange(m_up, up), up), false);
    if (m_isFitted) fit();
}

void SpaceNavigation::lookFrom(const attractor::Direction& direction) {
    m_isAlongAxis = true;
    project(); // first, because a listener may set the same projection, which is then no choice
    glideTo(attractor::turnedTo(m_camera, direction.azimuth, direction.elevation, m_up));
}

AxisBall::End SpaceNavigation::lookAlong(AxisBall::End end) {
    if (AxisBall::looksFrom(m_camera, end)) end.isPositive = !end.isPositive;
    lookFrom(AxisBall::towards(end, m_up));
    return end;
}

void SpaceNavigation::fixDirection(const attractor::Direction& direction) {
    m_glide.stop();
    m_isFixed = true;
    attractor::OrbitCamera turned =
        attractor::turnedTo(m_camera, direction.azimuth, direction.elevation, m_up);
    turned.projection = attractor::OrbitCamera::Projection::Orthographic;
    set(turned, false);
}

void SpaceNavigation::leaveAxisView() {
    m_isAlongAxis = false;
    project();
}

bool SpaceNavigation::isPerspective() const {
    return m_camera.projection == attractor::OrbitCamera::Projection::Perspective;
}

void SpaceNavigation::setPerspective(bool on) {
    if (on == isPerspective()) return;
    choosePerspective(on);
    project();
}

void SpaceNavigation::choosePerspective(bool on) {
    m_isPerspectiveChosen = on;
    m_isPerspectiveLent = false;
    m_isAlongAxis = false;
}

void SpaceNavigation::lendPerspective(bool on) {
    m_isPerspectiveLent = on;
    project();
}

void SpaceNavigation::project() {
    const bool on = m_isPerspectiveLent || (m_isPerspectiveChosen && !m_isAlongAxis);
    if (on == isPerspective()) return;
    using Projection = attractor::OrbitCamera::Projection;
    attractor::OrbitCamera changed = m_camera;
    changed.projection = on ? Projection::Perspective : Projection::Orthographic;
    m_glide.stop();
    set(changed, false);
    emit perspectiveChanged(on);
}

std::optional<ifs::Vector<3>> SpaceNavigation::pointUnder(const QPointF& position) const {
    const auto frame = m_bridge->frame();
    if (!frame) return std::nullopt;
    const ifs::Vector<2> pixel = toVector(inEye(position));
    const double depth = depthAt(*frame, pixel * pixelRatio());
    if (!std::isfinite(depth)) return std::nullopt;
    return toWorld(m_camera, {pixel, depth});
}

ifs::Vector<3> SpaceNavigation::pivotBeside() const {
    const document::Fractal& fractal = m_document->fractal();
    const bool isKnown = document::isSpaceExtentKnown(fractal);
    return (isKnown ? document::centreOfPicture(fractal) : std::nullopt).value_or(m_camera.target);
}

std::optional<ifs::Vector<3>> SpaceNavigation::pointNear(const QPointF& position) const {
    constexpr int reach = 4; // pixels
    double nearest = reach + 0.5;
    std::optional<ifs::Vector<3>> result;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const double away = std::hypot(x, y);
            const auto point = away < nearest ? pointUnder(position + QPointF(x, y)) : std::nullopt;
            if (!point) continue;
            nearest = away;
            result = point;
        }
    return result;
}

} // namespace view
