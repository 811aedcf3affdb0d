// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_navigation.h"
#include "bridges/solid_bridge.h"
#include "document/document.h"
#include "gestures/view_navigation.h"
#include "space/axis_ball.h"

#include <QFutureWatcher>
#include <QVariantAnimation>
#include <QWidget>

#include <memory>
#include <vector>

namespace view {

// Standard directions of view, whichever axis is up.
namespace directions {
constexpr attractor::Direction front{0, 0}, back{180, 0}, right{90, 0}, left{-90, 0}, top{0, 90},
    bottom{0, -90};
constexpr attractor::Direction isometric{45, 35.26438968275466}; // diagonal of a cube seen as a point
} // namespace directions

// The view of the window into space.
class SpaceNavigation : public ViewNavigation {
    Q_OBJECT

public:
    SpaceNavigation(document::Document* document, SolidBridge* bridge, const QWidget* viewport);

    const attractor::OrbitCamera& camera() const { return m_camera; } // size in device-independent pixels
    double pixelRatio() const { return m_viewport->devicePixelRatioF(); }
    QPointF middle() const override { return {m_camera.size.width / 2.0, m_camera.size.height / 2.0}; }

    // Moves on behalf of the user: the view then stays when the window changes its size. `isMoving`: more
    // calls follow.
    void moveTo(const attractor::OrbitCamera& camera, bool isMoving = false);
    void followKeys(attractor::OrbitCamera camera, bool isMoving); // ignores the size of `camera`
    void glideTo(const attractor::OrbitCamera& camera);            // short animated move
    void fit() override;                                           // fits picture and cage into the view
    bool isFitted() const override { return m_isFitted; }
    void zoomAt(const QPointF& position, double factor) override;
    void resetZoom() override; // scale of a unit at the target
    void lookFrom(const attractor::Direction& direction);
    // Looks along an axis from that end, or from the other one if it does so already; returns the end used.
    AxisBall::End lookAlong(AxisBall::End end);
    // Orbits by these degrees from `before`, in the user's mode of turning.
    void orbit(const attractor::OrbitCamera& before, const ifs::Vector<3>& pivot, double right, double up,
               bool isMoving = false);
    // Side by side, each eye has half of the window, with a camera of its own.
    void setStereo(attractor::Stereo stereo);
    attractor::Stereo stereo() const { return m_stereo; }
    QPointF inEye(const QPointF& position) const; // pixel of the eye's camera for a position in the window
    void setTrackball(bool on);                   // false: also levels the view
    void setUpAxis(attractor::UpAxis up);
    attractor::UpAxis upAxis() const { return m_up; }

    // Fixes the direction at once: nothing turns this view any more, and the user's views do not apply to it.
    void fixDirection(const attractor::Direction& direction);
    bool isFixed() const { return m_isFixed; }

    // A view along an axis is orthographic until one orbits.
    bool isPerspective() const;
    void leaveAxisView(); // called when an orbit begins
    void setPerspective(bool on);
    // Choice of the user, regardless of lendPerspective().
    bool isPerspectiveChosen() const { return m_isPerspectiveChosen; }
    // Temporary perspective, even along an axis, until it is taken back or the user chooses the projection.
    void lendPerspective(bool on);

    // The point of the attractor that is seen there; nullopt beside it.
    std::optional<ifs::Vector<3>> pointUnder(const QPointF& position) const;
    // The pivot for a drag beside the solid: the middle of the solid or, where that is not known, the target.
    ifs::Vector<3> pivotBeside() const;
    // The one that is seen nearest to it, a few pixels away at most: twigs are thin.
    std::optional<ifs::Vector<3>> pointNear(const QPointF& position) const;

signals:
    void changed();
    void perspectiveChanged(bool on);
    void stereoChanged();

private:
    void adoptViewport() override;
    void twistAt(const QPointF& position, double degrees) override;
    void hold() override { m_held = m_camera; }
    void moveHeld(const QPointF& shift, const QPointF& about = {}, double factor = 1) override {
        moveTo(moved(m_held, shift, inEye(about), factor), true);
    }
    void restoreHeld() override { moveTo(m_held); }
    void set(const attractor::OrbitCamera& camera, bool isMoving);
    void fitAgain();
    void seekMotion(const std::shared_ptr<const document::Fractal>& entry);
    void takeMotion(std::vector<ifs::Vector<3>> corners);
    void fitMotion();
    void choosePerspective(bool on);
    void project(); // applies the chosen projection

    document::Document* m_document;
    SolidBridge* m_bridge;
    const QWidget* m_viewport;
    attractor::OrbitCamera m_camera, m_held;
    QVariantAnimation m_glide;
    attractor::UpAxis m_up = attractor::UpAxis::Y;
    attractor::Stereo m_stereo = attractor::Stereo::None;
    bool m_isTrackball = false;
    bool m_isFixed = false;
    bool m_isPerspectiveChosen = false;
    bool m_isPerspectiveLent = false;
    bool m_isAlongAxis = false; // true also means an orthographic view
    bool m_isFitted = true;     // true: follows the size of the window until the user moves the view
    QFutureWatcher<std::vector<ifs::Vector<3>>> m_corners; // extent of the motion
    std::shared_ptr<const document::Fractal> m_sought, m_moving;
    std::vector<ifs::Vector<3>> m_motion; // extent of the motion of m_moving; empty: it does not move
    animation::Moment m_fitted; // moment to fit again when the window is resized, whichever is shown
};

} // namespace view
