// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/copies/copy_hierarchy.h"
#include "io/file/save_file.h"

#include "attractor/request/camera.h"
#include "document/fractal/fractal.h"

#include <optional>
#include <stop_token>
#include <vector>

// The shapes of a scalable picture, whatever file they are written to.
namespace io {

struct ShapeLevels {
    std::optional<ifs::CopyHierarchy> levels;
    Failure failure; // reason why there are none
};
ShapeLevels shapeLevels(const document::Fractal& fractal, const attractor::Camera& camera);

// A single colour in place of the shades of a picture made of points: the plain colour, or the bright part of
// the palette.
attractor::Rgba shapeColour(const attractor::Appearance& appearance);
// The colour of a copy in the picture; nullopt: that of all.
std::optional<attractor::Rgba> shapeColour(const document::Fractal& fractal, const ifs::CopyHierarchy& levels,
                                           const ifs::Copy& copy);

// The union of all copies of level 0 in a picture of this depth, in pixels: closed rings that touch neither
// themselves nor each other but in points; filled by the even-odd rule. Empty when stopped.
using Ring = std::vector<ifs::Vector<2>>;
std::vector<Ring> leafUnion(const ifs::CopyHierarchy& levels, int depth, const std::stop_token& stop = {});

// Points of the chaos game that the camera sees, in pixels, by colour. The system must be plane.
struct ColouredPoints {
    attractor::Rgba colour;
    std::vector<ifs::Vector<2>> points;
};
std::vector<ColouredPoints> shapePoints(const document::Fractal& fractal, const attractor::Camera& camera,
                                        std::uint64_t points, std::uint64_t seed);

// The shadow of a picture of shapes: the same shapes in the colours of `fractal`, as seen in `fractal` itself
// or taken there by `map`, in pixels. nullopt where the picture has none.
struct ShapeShadow {
    document::Fractal fractal;
    ifs::AffineMap<2> map;
    double opacity = 1; // opacity of all shapes together
};
std::optional<ShapeShadow> shapeShadow(const document::Fractal& fractal, const attractor::Camera& camera);

} // namespace io
