// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/scene/canvas_scene.h"
#include "document/fractal/fractal_geometry.h"
#include "gestures/view_navigation.h"

#include <QFutureWatcher>

#include <memory>
#include <optional>
#include <vector>

namespace view {

class RenderBridge;

// Where the canvas looks: sets the camera of the scene and of the picture. Zooming knows no limit but that of
// the numbers.
class CanvasNavigation : public ViewNavigation {
    Q_OBJECT

public:
    CanvasNavigation(CanvasScene& scene, RenderBridge& bridge, const QWidget& viewport);

    const attractor::Camera& camera() const { return m_scene.camera(); }
    void setCamera(const attractor::Camera& camera);
    void moveTo(const attractor::Camera& camera); // by the user: it stays so when the window changes its size
    void adoptViewport() override;
    QPointF middle() const override;

    // The attractor into the view, and the cage where that leaves the attractor at least half as large, else
    // those of its corners that lie just outside. That of many maps may come into view a little later. When
    // the window changes its size, the same moment of an animation is fitted again, whichever is shown.
    void fit() override;
    // What comes into the view with the attractor, such as the target of a collage.
    void setFittedToo(const std::optional<document::Box>& box) { m_fittedToo = box; }
    bool isFitted() const override { return m_isFitted; }
    void zoomBy(double factor); // about the middle
    void zoomAt(const QPointF& position, double factor) override;
    double zoom() const;         // 1: one unit of the plane is a hundred pixels
    void setZoom(double factor); // about the middle
    void resetZoom() override;   // the middle stays
    void pan(const QPointF& pixels);
    void setYAxis(attractor::YAxis yAxis);
    attractor::YAxis yAxis() const { return camera().yAxis; }
    // The view turns, counter-clockwise on the screen, in degrees: about the middle, or about a position.
    void rotateBy(double degrees);
    void rotateAt(const QPointF& position, double degrees);
    double rotation() const; // in (−180, 180]
    void resetRotation();

signals:
    void cameraChanged();
    void zoomed(const QPointF& position); // or turned, about it, in pixels

private:
    void twistAt(const QPointF& position, double degrees) override { rotateAt(position, -degrees); }
    void hold() override { m_held = camera(); }
    void moveHeld(const QPointF& shift, const QPointF& about = {}, double factor = 1) override {
        moveTo(moved(m_held, shift, about, factor));
    }
    void restoreHeld() override { setCamera(m_held); }
    void fitAgain();
    std::shared_ptr<const document::Fractal> fittedFractal() const;
    std::vector<ifs::Vector<2>> fittedCorners() const;
    void fitTo(std::optional<document::Box> attractor);

    CanvasScene& m_scene;
    RenderBridge& m_bridge;
    const QWidget& m_viewport;
    attractor::Camera m_held;
    std::optional<document::Box> m_fittedToo;
    bool m_isFitted = true; // follows the size of the window until the user moves the view
    animation::Moment m_fitted;
    QFutureWatcher<std::optional<document::Box>> m_extent; // of the attractor that is to be fitted
};

} // namespace view
