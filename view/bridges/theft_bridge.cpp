// SPDX-License-Identifier: MIT
#include "bridges/theft_bridge.h"

#include "attractor/threads/hardware_threads.h"

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr int maxThreads = 4;

} // namespace

TheftBridge::TheftBridge(document::Document* host, RenderBridge* onHost, document::PartnerDocument* partner,
                         RenderBridge* onPartner)
    : m_host(host),
      m_onHost(onHost),
      m_partner(partner),
      m_onPartner(onPartner),
      m_thread(
          std::make_unique<document::TheftThread>(std::min(attractor::hardwareThreads(), maxThreads), [this] {
              QMetaObject::invokeMethod(this, &TheftBridge::takeFrames, Qt::QueuedConnection);
          })) {
    for (const RenderBridge* bridge : {onHost, onPartner})
        connect(bridge, &RenderBridge::wanted, this, &TheftBridge::request);
    // Without a transformation nothing is wanted of it; the next change may bring one.
    for (const document::Document* of : {host, &partner->document()})
        connect(of, &document::Document::changed, this, [this](const document::Change& change) {
            if (!m_isSubstituting) request(change.live);
        });
    connect(partner, &document::PartnerDocument::partnerChanged, this, [this] { request(false); });
}

TheftBridge::~TheftBridge() = default;

void TheftBridge::setActive(bool active) {
    if (std::exchange(m_isActive, active) == active) return;
    request(false);
}

void TheftBridge::setTheft(const document::KeptTheft& theft) {
    if (m_theft == theft) return;
    m_theft = theft;
    request(false);
}

void TheftBridge::setOverlay(double opacity) {
    if (std::exchange(m_overlay, opacity) != opacity) request(false);
}

void TheftBridge::setPicture(std::shared_ptr<const attractor::MipPicture> picture) {
    m_picture = std::move(picture);
    request(false);
}

void TheftBridge::request(bool live) {
    if (!m_isActive || !m_picture || m_partner->id() == document::EntryId::None ||
        !document::plane(m_host->fractal())) {
        m_thread->cancel();
        substitute(false);
        return;
    }
    document::TheftJob job;
    job.from = {m_host->sharedFractal(), m_onHost->camera(), m_onHost->requested()};
    job.to = {m_partner->document().sharedFractal(), m_onPartner->camera(), m_onPartner->requested()};
    job.order = m_theft.order;
    job.mode = m_theft.mode;
    job.view = m_theft.view;
    job.picture = m_picture;
    job.overlay = m_overlay;
    job.isLive = live;
    m_thread->submit(std::move(job));
}

void TheftBridge::takeFrames() {
    const std::shared_ptr<const document::StolenFrames> frames = m_thread->newest();
    if (!frames || !m_isActive || m_partner->id() == document::EntryId::None) return;
    const bool hadFlaw = m_flaw.has_value();
    m_flaw = frames->flaw;
    if (m_flaw || hadFlaw) emit flawChanged();
    if (m_flaw) return substitute(false);
    if (!m_isSubstituting) return substitute(true); // which asks for pictures of its own
    if (frames->from) m_onHost->take(frames->from);
    if (frames->to) m_onPartner->take(frames->to);
}

// Pictures that another has put in place of the density stay.
void TheftBridge::substitute(bool on) {
    if (std::exchange(m_isSubstituting, on) == on) return;
    m_onHost->setSubstituted(on);
    m_onPartner->setSubstituted(on);
    emit paintedChanged();
}

} // namespace view
