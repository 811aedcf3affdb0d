// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/solid_thread.h"
#include "document/document.h"

#include <QObject>

#include <memory>

namespace view {

// The counterpart of RenderBridge in space: every change of a fractal or of the camera becomes a request,
// every finished picture a signal in the GUI thread.
class SolidBridge : public QObject {
    Q_OBJECT

public:
    explicit SolidBridge(document::Document* document, QObject* parent = nullptr);
    ~SolidBridge() override;

    // Sets the camera, in device pixels; nothing is drawn before the first. `isMoving`: a hand turns it, and
    // more calls follow.
    void setCamera(const attractor::OrbitCamera& camera, bool isMoving);
    const attractor::OrbitCamera& camera() const { return m_camera; }
    void setStereo(attractor::Stereo stereo); // also makes the camera that of each eye

    // Draws this in place of the document, which must be in space, too; nullptr: the document again.
    void showInstead(std::shared_ptr<const document::Fractal> fractal);

    // nullptr before the first, and while the entry is not in space.
    std::shared_ptr<const attractor::SolidFrame> frame() const { return m_frame; }
    bool isCurrent() const; // true if the frame is exact and shows the present document and camera

signals:
    void frameChanged();

private:
    void follow(const document::Change& change);
    void request(bool isLive);
    void takeFrame();

    document::Document* m_document;
    std::shared_ptr<const document::Fractal> m_instead; // fractal shown in place of the document; null: none
    attractor::OrbitCamera m_camera;
    attractor::Stereo m_stereo = attractor::Stereo::None;
    std::shared_ptr<const attractor::SolidFrame> m_frame;
    std::uint64_t m_requested = 0;                    // revision of the newest request
    std::unique_ptr<attractor::SolidThread> m_thread; // last member: its thread uses the others
};

} // namespace view
