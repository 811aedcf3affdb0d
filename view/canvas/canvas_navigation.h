// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/scene/canvas_scene.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/motion_extent.h"
#include "gestures/view_navigation.h"

#include <QFutureWatcher>

#include <memory>
#include <optional>
#include <vector>

namespace view {

class RenderBridge;

// The view of the canvas: sets the camera of the scene and of the picture. Zooming has no limit but the range
// of the numbers.
class CanvasNavigation : public ViewNavigation {
    Q_OBJECT

public:
    CanvasNavigation(CanvasScene& scene, RenderBridge& bridge, const QWidget& viewport);

    const attractor::Camera& camera() const { return m_scene.camera(); }
    void setCamera(const attractor::Camera& camera);
    // Camera chosen by the user: the view stays when the window is resized.
    void moveTo(const attractor::Camera& camera);
    void adoptViewport() override;
    QPointF middle() const override;

    // The attractor into the view, and the cage where that leaves the attractor at least half as large, or
    // did before the cage was dragged; else those of its corners that lie just outside. Of an animation,
    // whatever it shows from its first moment to its last. That of many maps may come into view a little
    // later.
    void fit() override;
    // The same with all corners of the cage and of what is held, however small that makes the attractor.
    void fitCorners();
    // A box to fit into the view together with the attractor, such as the target of a collage.
    void setFittedToo(const std::optional<document::Box>& box) { m_fittedToo = box; }
    bool isFitted() const override { return m_isFitted; }
    void zoomBy(double factor); // centred
    void zoomAt(const QPointF& position, double factor) override;
    double zoom() const;         // 1: a hundred pixels per unit of the plane
    void setZoom(double factor); // centred
    void resetZoom() override;   // keeps the centre
    void pan(const QPointF& pixels);
    void setYAxis(attractor::YAxis yAxis);
    attractor::YAxis yAxis() const { return camera().yAxis; }
    // The view turns, counter-clockwise on the screen, in degrees: about the middle, or about a position.
    void rotateBy(double degrees);
    void rotateAt(const QPointF& position, double degrees);
    double rotation() const; // degrees in (−180, 180]
    void resetRotation();

signals:
    void cameraChanged();
    void zoomed(const QPointF& position); // centre in pixels; also sent for rotations

private:
    void twistAt(const QPointF& position, double degrees) override { rotateAt(position, -degrees); }
    void hold() override { m_held = camera(); }
    void moveHeld(const QPointF& shift, const QPointF& about = {}, double factor = 1) override {
        moveTo(moved(m_held, shift, about, factor));
    }
    void restoreHeld() override { setCamera(m_held); }
    enum class Corners { Near, All };
    void fitAgain();
    bool fitsMotion() const; // true if the entry moves
    void takeExtent(document::MotionExtent extent);
    void fitTo(const document::MotionExtent& extent);

    CanvasScene& m_scene;
    RenderBridge& m_bridge;
    const QWidget& m_viewport;
    attractor::Camera m_held;
    std::optional<document::Box> m_fittedToo;
    bool m_isFitted = true; // true: follows the size of the window until the user moves the view
    Corners m_corners = Corners::Near;
    QFutureWatcher<document::MotionExtent> m_extent; // extent to be fitted
    // The extent of the whole motion that was found last, and the entry it belongs to.
    std::shared_ptr<const document::Fractal> m_moving, m_sought;
    document::MotionExtent m_motion;
};

} // namespace view
