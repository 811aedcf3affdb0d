// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"
#include "render/render_view.h"

#include "attractor/request/orbit_camera.h"
#include "document/moments/animated_fractal.h"

// Content of an entry at one moment.
namespace cli {

struct Shown {
    document::Fractal fractal;                      // fractal to draw
    document::Fractal entry;                        // fractal to embed in pictures
    std::optional<attractor::View> view{};          // keyed view of an entry in the plane
    std::optional<attractor::OrbitCamera> camera{}; // keyed camera of an entry in space
    std::vector<animation::CameraTurn> orbit{};     // orbit of the camera in space: animation::orbited()
    // The view of all frames of an animation, which they share when they have no camera of their own.
    std::optional<ViewBox> box{};    // plane only
    attractor::Support support = {}; // space only
};

// The entry at rest, or at --frame; in the plane with the colours that are asked for. Throws UsageError for a
// frame outside of the animation.
Shown shownBy(const document::Fractal& entry, const RenderArguments& arguments);

// The same for one frame after another: common data is computed once.
class Frames {
public:
    Frames(const document::Fractal& entry, const RenderArguments& arguments);

    Shown at(const animation::Moment& moment) const;

private:
    const RenderArguments& m_arguments;
    document::Fractal m_entry;
    document::LastingCage m_lasting; // set if the cage is drawn
    Shown m_common;
};

// Says that the moment is after the last frame of the entry; empty if it is not.
QString frameObstacle(const document::Fractal& entry, const animation::Moment& moment);

} // namespace cli
