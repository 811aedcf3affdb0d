// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "document/fractal/fractal.h"
#include "ifs/system/affine_map.h"

#include <QString>

#include <optional>

// The shadow of a picture, as functions from fractal to fractal.
namespace document {

// Why the entry has no shadow to switch on; empty when it can have one.
QString shadowObstacle(const Fractal& fractal);

bool hasShadow(const Fractal& fractal);
// Turns the shadow on or off; its position is kept while it is off.
Fractal withShadow(Fractal fractal, bool on);

// An upright stick as high as the picture, and the end of its shadow: by that a shadow is held. World
// coordinates.
struct ShadowStick {
    ifs::Vector<2> foot; // point on the ground, in the middle of the picture
    ifs::Vector<2> top;
    ifs::Vector<2> tip; // tip of the shadow
};
// nullopt without a shadow, and where the picture has no height that is known.
std::optional<ShadowStick> shadowStick(const Fractal& fractal, attractor::YAxis yAxis);
// The shadow of that stick ends at `tip`, or as near to it as shadows are long. Needs the stick.
Fractal withShadowTip(Fractal fractal, const ShadowStick& stick, const ifs::Vector<2>& tip);

} // namespace document
