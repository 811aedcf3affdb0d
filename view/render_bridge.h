// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/camera.h"
#include "attractor/render_thread.h"
#include "document/document.h"

#include <QObject>

#include <memory>

namespace view {

// The only place that knows both the document and the render thread: every change of the document or the
// camera becomes a request, every finished frame a signal in the GUI thread.
class RenderBridge : public QObject {
    Q_OBJECT

public:
    explicit RenderBridge(document::Document* document, QObject* parent = nullptr);
    ~RenderBridge() override;

    void setCamera(const attractor::Camera& camera); // in device pixels
    const attractor::Camera& camera() const { return m_camera; }

    std::shared_ptr<const attractor::Frame> frame() const { return m_frame; } // nullptr before the first

signals:
    void frameChanged();

private:
    void request(bool live);
    void takeFrame();

    document::Document* m_document;
    attractor::Camera m_camera;
    std::shared_ptr<const attractor::Frame> m_frame;
    bool m_live = false;
    std::unique_ptr<attractor::RenderThread> m_thread; // last: stops before the rest goes
};

} // namespace view
