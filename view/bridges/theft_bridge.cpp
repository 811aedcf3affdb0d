// SPDX-License-Identifier: MIT
#include "bridges/theft_bridge.h"

#include "attractor/threads/hardware_threads.h"

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr int maxTheftThreads = 4;

} // namespace

TheftBridge::TheftBridge(document::Document* host, RenderBridge* onHost, document::PartnerDocument* partner,
                         RenderBridge* onPartner)
    : m_host(host),
      m_onHost(onHost),
      m_partner(partner),
      m_onPartner(onPartner),
      m_thread(std::make_unique<document::TheftThread>(
          std::min(attractor::hardwareThreads(), maxTheftThreads),
          [this] { QMetaObject::invokeMethod(this, &TheftBridge::takeFrames, Qt::QueuedConnection); })) {
    for (const RenderBridge* bridge : {onHost, onPartner})
        connect(bridge, &RenderBridge::wanted, this, &TheftBridge::request);
    // Follows both documents, because any change may make a transformation possible.
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
    m_firstJob = m_lastJob + 1;
    request(false);
}

void TheftBridge::setOverlay(double opacity) {
    if (std::exchange(m_overlay, opacity) != opacity) request(false);
}

void TheftBridge::setPicture(std::shared_ptr<const attractor::MipPicture> picture) {
    m_picture = std::move(picture);
    m_firstJob = m_lastJob + 1;
    request(false);
}

void TheftBridge::request(bool live) {
    if (!m_isActive || !m_picture || m_partner->id() == document::EntryId::None ||
        !document::plane(m_host->fractal())) {
        m_thread->cancel();
        m_from.reset();
        setFlaw(std::nullopt);
        substitute(false);
        return;
    }
    compare(live);
    document::TheftJob job;
    job.number = ++m_lastJob;
    job.from = {m_from, m_onHost->camera(), m_onHost->requested()};
    job.to = {m_to, m_onPartner->camera(), m_onPartner->requested()};
    job.order = m_theft.order;
    job.mode = m_theft.mode;
    job.view = m_theft.view;
    job.picture = m_picture;
    job.overlay = m_overlay;
    job.isLive = live;
    m_thread->submit(std::move(job));
}

// Drops results after an edit, since they are those of the entries before it. During a gesture they stay
// until there are new ones, so that nothing flickers.
void TheftBridge::compare(bool live) {
    const auto from = m_host->sharedFractal(), to = m_partner->document().sharedFractal();
    if (from == m_from && to == m_to && m_theft.order == m_order) return;
    m_from = from;
    m_to = to;
    m_order = m_theft.order;
    if (live) return;
    m_firstJob = m_lastJob + 1;
    setFlaw(document::evidentFlaw(*from, *to, m_order));
}

void TheftBridge::setFlaw(std::optional<document::CouplingOutcome> flaw) {
    const bool isSaid = m_flaw || flaw;
    m_flaw = std::move(flaw);
    if (isSaid) emit flawChanged();
}

void TheftBridge::takeFrames() {
    const std::shared_ptr<const document::StolenFrames> frames = m_thread->newest();
    if (!frames || frames->number < m_firstJob || !m_isActive || !m_picture ||
        m_partner->id() == document::EntryId::None)
        return;
    setFlaw(frames->flaw);
    if (m_flaw) return substitute(false);
    if (!m_isSubstituting) return substitute(true); // requests pictures of its own
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
