// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/render_bridge.h"
#include "document/tops/partner_document.h"
#include "document/tops/theft_thread.h"

#include <QObject>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace view {

// Connects a fractal transformation to the two canvases that show it: every change of either fractal, either
// camera or the picture becomes a job, every finished pair of pictures goes to the render bridges. Without a
// transformation, these show densities.
class TheftBridge : public QObject {
    Q_OBJECT

public:
    TheftBridge(document::Document* host, RenderBridge* onHost, document::PartnerDocument* partner,
                RenderBridge* onPartner);
    ~TheftBridge() override;

    void setActive(bool active);
    // Sets the order, the mode and the view of a kept transformation.
    void setTheft(const document::KeptTheft& theft);
    void setOverlay(double opacity); // opacity of the partner over the fractal
    void setPicture(std::shared_ptr<const attractor::MipPicture> picture); // null: none yet

    const std::shared_ptr<const attractor::MipPicture>& picture() const { return m_picture; }
    // Why there is no transformation between the entries as they are now, as far as is known.
    const std::optional<document::CouplingOutcome>& flaw() const { return m_flaw; }

signals:
    void flawChanged();
    void paintedChanged(); // sent when the canvases begin or cease to show a transformation

private:
    void request(bool live);
    void compare(bool live);
    void setFlaw(std::optional<document::CouplingOutcome> flaw);
    void takeFrames();
    void substitute(bool on);

    document::Document* m_host;
    RenderBridge* m_onHost;
    document::PartnerDocument* m_partner;
    RenderBridge* m_onPartner;
    document::KeptTheft m_theft;
    std::shared_ptr<const attractor::MipPicture> m_picture;
    std::optional<document::CouplingOutcome> m_flaw;
    std::shared_ptr<const document::Fractal> m_from, m_to; // fractals of the last job
    std::vector<std::size_t> m_order;
    std::uint64_t m_lastJob = 0;
    std::uint64_t m_firstJob = 1; // first job of the present entries and picture
    double m_overlay = 0;
    bool m_isActive = false;
    bool m_isSubstituting = false;
    std::unique_ptr<document::TheftThread> m_thread; // last member: its thread uses the others
};

} // namespace view
