// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/render_bridge.h"
#include "document/tops/partner_document.h"
#include "document/tops/theft_thread.h"

#include <QObject>

#include <memory>
#include <optional>

namespace view {

// Between a fractal transformation and the two canvases that show it: every change of either fractal, either
// camera or the picture becomes a job, every finished pair of pictures goes to the render bridges. While
// there is no transformation, they show densities.
class TheftBridge : public QObject {
    Q_OBJECT

public:
    TheftBridge(document::Document* host, RenderBridge* onHost, document::PartnerDocument* partner,
                RenderBridge* onPartner);
    ~TheftBridge() override;

    void setActive(bool active);
    // Of what is kept: the order, the mode, the view.
    void setTheft(const document::KeptTheft& theft);
    void setOverlay(double opacity);                                       // of the partner over the fractal
    void setPicture(std::shared_ptr<const attractor::MipPicture> picture); // null: none yet

    const std::shared_ptr<const attractor::MipPicture>& picture() const { return m_picture; }
    // Why there is no transformation, as far as is known; without value where there is one.
    const std::optional<document::CouplingOutcome>& flaw() const { return m_flaw; }

signals:
    void flawChanged();
    void paintedChanged(); // whether the canvases show a transformation

private:
    void request(bool live);
    void takeFrames();
    void substitute(bool on);

    document::Document* m_host;
    RenderBridge* m_onHost;
    document::PartnerDocument* m_partner;
    RenderBridge* m_onPartner;
    document::KeptTheft m_theft;
    std::shared_ptr<const attractor::MipPicture> m_picture;
    std::optional<document::CouplingOutcome> m_flaw;
    double m_overlay = 0;
    bool m_isActive = false;
    bool m_isSubstituting = false;
    std::unique_ptr<document::TheftThread> m_thread; // last: stops before the rest goes
};

} // namespace view
