// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "document/fractal/fractal.h"

// What a picture must show when nobody says; frames of an animation share it.
namespace io {

struct ViewBox {
    ifs::Vector<2> min;
    ifs::Vector<2> max;
    bool certified = true; // false: where orbits spend most of their time
};

ViewBox boxOfAttractor(const document::Fractal& fractal); // in the plane, as displayed, under its cage

// Of an entry with an animation, at up to 121 moments in the plane and 33 in space: margins cover what is
// between them. Moments that are proved to have no attractor, whose points escape, count only where no other
// does.
ViewBox boxOfFrames(const document::Fractal& entry);
attractor::Support supportOfFrames(const document::Fractal& entry);

bool hasCameraKeys(const document::Fractal& entry); // which then say what is shown

} // namespace io
