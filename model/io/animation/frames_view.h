// SPDX-License-Identifier: MIT
#pragma once

#include "animation/paths/camera_path.h"
#include "attractor/request/camera.h"
#include "attractor/request/orbit_camera.h"
#include "document/fractal/fractal.h"

#include <span>

// Default view of a picture; frames of an animation share it.
namespace io {

struct ViewBox {
    ifs::Vector<2> min;
    ifs::Vector<2> max;
    bool certified = true; // false: region in which orbits spend most of their time
};

// Box in the plane, as displayed, of the picture under its cage and with its shadow.
ViewBox boxOfAttractor(const document::Fractal& fractal, attractor::YAxis yAxis = attractor::YAxis::Up);

// The box of an entry with an animation, at up to 121 moments in the plane and 33 in space: margins cover the
// time between them. Moments proved to have no attractor, whose points escape, count only if there are no
// others.
ViewBox boxOfFrames(const document::Fractal& entry, attractor::YAxis yAxis = attractor::YAxis::Up);
// Support of the frames in space, as seen by a camera that has not gone round yet: turns about a pivot are
// taken back. Turns about the target of the camera are not, because the target is not known.
attractor::Support supportOfFrames(const document::Fractal& entry);

// The support of what a camera that has not gone round yet sees in the same place as it sees the set of
// `support` after these turns; `support` itself where a turn goes about the target of the camera.
attractor::Support supportBefore(std::span<const animation::CameraTurn> turns, attractor::Support support);

// The camera at a moment whose turns are given, which shows all of the frames: one that turns about pivots
// keeps its height, so that nothing grows or shrinks while it goes round.
attractor::OrbitCamera cameraOfFrame(const attractor::OrbitCamera& atRest,
                                     std::span<const animation::CameraTurn> turns,
                                     const attractor::Support& allFrames, double margin = 0.05);

// A camera for a key, which looks as `camera` does and shows all of the frames of an entry in space while it
// goes round.
attractor::OrbitCamera cameraOfFrames(document::Fractal entry, const attractor::OrbitCamera& camera);

bool hasCameraKeys(const document::Fractal& entry); // true if camera keys determine the view

} // namespace io
