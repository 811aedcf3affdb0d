// SPDX-License-Identifier: MIT
#include "bridges/render_bridge.h"

#include "attractor/render/renderer.h"
#include "attractor/threads/hardware_threads.h"
#include "bridges/solo_switch.h"
#include "document/fractal/fractal.h"
#include "document/fractal/fractal_geometry.h"
#include "document/maps/map_solo.h"

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr std::uint64_t minSamples = 1'000'000;
constexpr std::uint64_t maxSamples = 10'000'000; // samples in the first pass
constexpr double fluid = 14;                     // milliseconds for one frame of a gesture
constexpr int maxThreads = 4; // limit, because each thread has counters of 8 MB for a large canvas
constexpr int patience = 400; // milliseconds that a change waits for the previous frame

} // namespace

RenderBridge::RenderBridge(document::Document* document, QObject* parent)
    : QObject(parent), m_document(document), m_thread(std::make_unique<attractor::RenderThread>([this] {
          QMetaObject::invokeMethod(this, &RenderBridge::takeFrame, Qt::QueuedConnection);
      })) {
    m_underWay.setSingleShot(true);
    m_underWay.setInterval(patience);
    connect(&m_underWay, &QTimer::timeout, this, [this] {
        if (m_waiting) submit();
    });
    connect(document, &document::Document::changed, this, &RenderBridge::follow);
    connect(new SoloSwitch(this), &SoloSwitch::changed, this, [this] {
        m_exposing = Exposing::Measured;
        request(Haste::Now);
    });
}

RenderBridge::~RenderBridge() = default;

void RenderBridge::setCamera(const attractor::Camera& camera) {
    if (camera == m_camera) return;
    m_camera = camera;
    if (m_exposing == Exposing::Kept) m_exposing = Exposing::Eased;
    request(Haste::InTurn);
}

void RenderBridge::setQuality(std::uint64_t samples) {
    if (samples == m_quality) return;
    m_quality = samples;
    request(Haste::Now);
    emit qualityChanged(samples);
}

void RenderBridge::showDensity() {
    show({});
}

void RenderBridge::showSteps(int iterations) {
    show({attractor::Algorithm::Deterministic, iterations, 0, 1});
}

void RenderBridge::showChaosGame(std::uint64_t points, std::uint64_t seed) {
    show({attractor::Algorithm::ChaosGame, 0, points, seed});
}

void RenderBridge::show(const Shown& shown) {
    if (shown == m_shown) return;
    const bool otherwise = shown.algorithm != m_shown.algorithm;
    m_shown = shown;
    m_exposing = Exposing::Measured;
    if (otherwise) m_shownFrom = m_requested + 1;
    request(otherwise ? Haste::Now : Haste::InTurn);
}

void RenderBridge::fixLiveSamples(std::uint64_t samples) {
    m_liveSamples = samples;
    m_adapting = false;
}

void RenderBridge::showInstead(std::shared_ptr<const document::Fractal> fractal) {
    if (fractal == m_instead) return;
    m_instead = std::move(fractal);
    // Keeps the brightness continuous from a motion to the picture at rest.
    m_exposing = std::exchange(m_isMoving, false) ? Exposing::Eased : Exposing::Measured;
    request(Haste::Now);
}

void RenderBridge::showMoving(std::shared_ptr<const document::Fractal> fractal) {
    m_instead = std::move(fractal);
    m_isMoving = true;
    if (m_exposing == Exposing::Kept) m_exposing = Exposing::Eased;
    request(Haste::InTurn);
}

bool RenderBridge::isCurrent() const {
    return m_frame && m_frame->revision == m_requested && !m_waiting;
}

void RenderBridge::follow(const document::Change& change) {
    using document::Change;
    if (!(change.parts &
          (Change::System | Change::Cage | Change::Appearance | Change::Current | Change::File)))
        return;
    m_live = change.live;
    const bool otherPicture = change.parts & (Change::Current | Change::File);
    const bool moved = change.parts & Change::Time; // keeps the brightness of frames continuous
    const bool edited = !change.live && !moved && (change.parts & (Change::System | Change::Appearance));
    if (moved && m_exposing == Exposing::Kept) m_exposing = Exposing::Eased;
    if (otherPicture || edited) m_exposing = Exposing::Measured;
    request(m_live || moved ? Haste::InTurn : Haste::Now);
}

void RenderBridge::request(Haste haste) {
    if (haste == Haste::InTurn && m_underWay.isActive())
        m_waiting = true;
    else
        submit();
}

void RenderBridge::submit() {
    m_waiting = false;
    m_underWay.stop();
    const document::Fractal& fractal = m_instead ? *m_instead : m_document->fractal();
    if (!document::system2(fractal)) {
        m_thread->cancel();
        ++m_requested;
        m_exposing = Exposing::Measured;
        if (std::exchange(m_frame, nullptr)) emit frameChanged();
        return;
    }
    if (m_camera.width <= 0 || m_camera.height <= 0) return;
    if (m_isSubstituted) {
        ++m_requested;
        m_underWay.start();
        emit wanted(m_live);
        return;
    }
    const ifs::MapId solo = m_instead ? ifs::MapId::None : SoloSwitch::of(*this);
    attractor::RenderRequest request =
        solo == ifs::MapId::None ? document::renderRequest(fractal, m_camera)
                                 : document::renderRequest(document::soloed(fractal, solo), m_camera);
    request.revision = ++m_requested;
    request.threads = std::min(attractor::hardwareThreads(), maxThreads);
    request.samples = m_live || m_isMoving ? m_liveSamples : maxSamples;
    std::uint64_t quality = m_quality;
    if (m_shown.algorithm != attractor::Algorithm::Density) {
        request.algorithm = m_shown.algorithm;
        request.iterations = m_shown.iterations;
        request.seed = m_shown.seed;
        quality = request.samples = m_shown.points;
        m_exposing = Exposing::Measured;
        if (!attractor::coloursSamples(
                request.appearance.colourBy)) // the colour of the last map is what the chaos game explains
            request.appearance.colourBy = attractor::ColourBy::Map;
        if (m_shown.algorithm == attractor::Algorithm::Deterministic)
            request.cage = document::effectiveCage(fractal);
    }
    using Brightness = attractor::RenderThread::Brightness;
    const auto brightness = m_exposing == Exposing::Measured ? Brightness::OfThePicture
                            : m_exposing == Exposing::Eased  ? Brightness::Eased
                                                             : Brightness::Continued;
    if (m_exposing == Exposing::Measured) m_measuredFrom = m_requested;
    if (m_exposing == Exposing::Kept && m_frame && m_frame->revision >= m_measuredFrom)
        request.exposure = m_frame->exposure;
    m_exposing = Exposing::Kept;
    m_thread->submit(std::move(request), quality, brightness);
    m_underWay.start();
}

void RenderBridge::takeFrame() {
    std::shared_ptr<const attractor::Frame> frame = m_thread->newestFrame();
    if (!frame || frame == m_frame || m_isSubstituted || !document::system2(m_document->fractal())) return;
    m_frame = std::move(frame);
    const bool density =
        m_shown.algorithm == attractor::Algorithm::Density && m_frame->revision >= m_shownFrom;
    if (m_frame->passes == 1 && density) adaptBudget(*m_frame);
    turnEnds();
}

void RenderBridge::turnEnds() {
    if (m_frame->revision == m_requested) {
        m_underWay.stop();
        if (m_waiting) submit();
    }
    emit frameChanged();
}

void RenderBridge::setSubstituted(bool on) {
    if (std::exchange(m_isSubstituted, on) == on) return;
    if (on) m_thread->cancel();
    m_exposing = Exposing::Measured;
    request(Haste::Now);
}

void RenderBridge::take(std::shared_ptr<const attractor::Frame> frame) {
    if (!m_isSubstituted || frame == m_frame || !document::system2(m_document->fractal())) return;
    m_frame = std::move(frame);
    turnEnds();
}

void RenderBridge::adaptBudget(const attractor::Frame& frame) {
    if (!m_adapting || frame.milliseconds <= 0 || frame.samples == 0) return;
    const double affordable = double(frame.samples) * fluid / frame.milliseconds;
    // Adapts by half the difference, so that one slow frame on a busy machine does not change the grain
    // abruptly.
    m_liveSamples = std::clamp(std::uint64_t((double(m_liveSamples) + std::min(affordable, 1e12)) / 2),
                               minSamples, maxSamples);
}

} // namespace view
