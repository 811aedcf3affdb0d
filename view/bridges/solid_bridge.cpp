// SPDX-License-Identifier: MIT
#include "bridges/solid_bridge.h"

#include "attractor/threads/hardware_threads.h"
#include "bridges/solo_switch.h"
#include "document/fractal/space_geometry.h"
#include "document/maps/map_solo.h"

#include <utility>

namespace view {

SolidBridge::SolidBridge(document::Document* document, QObject* parent)
    : QObject(parent), m_document(document), m_thread(std::make_unique<attractor::SolidThread>([this] {
          QMetaObject::invokeMethod(this, &SolidBridge::takeFrame, Qt::QueuedConnection);
      })) {
    connect(document, &document::Document::changed, this, &SolidBridge::follow);
    connect(new SoloSwitch(this), &SoloSwitch::changed, this, [this] { request(false); });
}

SolidBridge::~SolidBridge() = default;

void SolidBridge::setCamera(const attractor::OrbitCamera& camera, bool isMoving) {
    if (camera == m_camera) return;
    m_camera = camera;
    request(isMoving);
}

void SolidBridge::setStereo(attractor::Stereo stereo) {
    if (std::exchange(m_stereo, stereo) != stereo) request(false);
}

void SolidBridge::showInstead(std::shared_ptr<const document::Fractal> fractal) {
    if (fractal == m_instead) return;
    m_instead = std::move(fractal);
    request(false);
}

bool SolidBridge::isCurrent() const {
    return m_frame && m_frame->revision == m_requested && m_frame->step == 1;
}

void SolidBridge::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & (Change::System | Change::Cage | Change::Appearance | Change::Current | Change::File))
        request(change.live);
}

void SolidBridge::request(bool isLive) {
    const ifs::MapId solo = m_instead ? ifs::MapId::None : SoloSwitch::of(*this);
    const bool isSolo = solo != ifs::MapId::None;
    const document::Fractal& fractal = m_instead ? *m_instead : m_document->fractal();
    ++m_requested;
    if (!document::space(fractal)) {
        m_thread->cancel();
        if (std::exchange(m_frame, nullptr)) emit frameChanged();
        return;
    }
    if (!attractor::isUsable(m_camera)) return;
    const document::Fractal shown = isSolo ? document::soloed(fractal, solo) : document::Fractal();
    const document::Fractal& drawn = isSolo ? shown : fractal;
    attractor::SpaceRequest request = document::spaceRequest(drawn, m_camera);
    request.revision = m_requested;
    request.threads = attractor::hardwareThreads();
    m_thread->submit(
        {std::move(request), drawn.inSpace.look, document::solidAppearance(drawn), isLive, m_stereo});
}

void SolidBridge::takeFrame() {
    auto frame = m_thread->newestFrame();
    if (!frame || frame == m_frame || !document::space(m_document->fractal())) return;
    m_frame = std::move(frame);
    emit frameChanged();
}

} // namespace view
