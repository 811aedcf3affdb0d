// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/solid_bridge.h"
#include "document/document.h"
#include "space/axis_ball.h"

#include <QVariantAnimation>
#include <QWidget>

namespace view {

// Where the window into space looks.
class SpaceNavigation : public QObject {
    Q_OBJECT

public:
    SpaceNavigation(document::Document* document, SolidBridge* bridge, const QWidget* viewport);

    const attractor::OrbitCamera& camera() const { return m_camera; } // in device-independent pixels
    double pixelRatio() const { return m_viewport->devicePixelRatioF(); }
    QPointF middle() const { return {m_camera.size.width / 2.0, m_camera.size.height / 2.0}; }

    // By the user: it stays so when the window changes its size. `isMoving`: more of the same is to come.
    void moveTo(const attractor::OrbitCamera& camera, bool isMoving = false);
    void glideTo(const attractor::OrbitCamera& camera); // within a moment
    void adoptViewport();                               // its size and pixel ratio
    void fit();                                         // picture and cage into the view
    bool isFitted() const { return m_isFitted; }        // and the user has not moved the view since
    void zoomAt(const QPointF& position, double factor);
    void resetZoom(); // 100 %: one unit at the target is a hundred pixels
    void lookFrom(const AxisBall::Direction& direction);

    void fixDirection(const AxisBall::Direction& direction); // at once; the user's views are not for this one

    // A view along an axis is orthographic until one orbits.
    bool isPerspective() const;
    void leaveAxisView(); // one orbits now
    void setPerspective(bool on);

    // The point of the attractor that is seen there; nullopt beside it.
    std::optional<ifs::Vector<3>> pointUnder(const QPointF& position) const;

signals:
    void changed();
    void perspectiveChanged(bool on);

private:
    void set(const attractor::OrbitCamera& camera, bool isMoving);

    document::Document* m_document;
    SolidBridge* m_bridge;
    const QWidget* m_viewport;
    attractor::OrbitCamera m_camera;
    QVariantAnimation m_glide;
    bool m_wasPerspective = false; // before a view along an axis
    bool m_isFitted = true;        // follows the size of the window until the user moves the view
};

} // namespace view
