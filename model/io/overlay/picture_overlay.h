// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/tone_map16.h"
#include "attractor/request/camera.h"
#include "document/fractal/fractal.h"
#include "document/tops/map_faces.h"
#include "io/overlay/overlay_marks.h"

#include <QImage>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace io {

// Parts drawn over a picture to explain it.
struct PictureOverlay {
    bool maps = false;        // image of the cage under each map, in the map's colour
    bool hull = false;        // convex hull of the attractor
    bool cage = false;        // current polygon
    bool fixedPoints = false; // fixed points of the maps
    bool numbers = false;     // numbers of the maps, each in its image of the cage
    bool showsRest = true;    // with the cage: the rest polygon, dashed, where it differs
    bool isCageInked = false; // cage in the ink of the hull, since a map may have the colour of the cage

    friend bool operator==(const PictureOverlay&, const PictureOverlay&) = default;
};

// A part of an overlay under its name on the command line.
struct OverlayPart {
    const char* id;
    bool PictureOverlay::*isShown;
};
inline constexpr auto overlayParts = std::to_array<OverlayPart>({
    {"maps", &PictureOverlay::maps},
    {"hull", &PictureOverlay::hull},
    {"cage", &PictureOverlay::cage},
    {"fixed-points", &PictureOverlay::fixedPoints},
    {"numbers", &PictureOverlay::numbers},
});

// The shapes of an overlay, worked out once for all rows of a picture. The fractal is a system of the plane.
// Its maps have those faces; empty: their own.
OverlayMarks overlayMarks(const document::Fractal& fractal, const attractor::Camera& camera,
                          const PictureOverlay& overlay, const document::MapFaces& faces = {});

// Points that must be in view for these shapes to be seen: the corners of the cage and of its images.
std::vector<ifs::Vector<2>> overlayPoints(const document::Fractal& fractal, const PictureOverlay& overlay);

// An image that paints into whole rows of pixels.
QImage imageOver(std::span<std::uint32_t> pixels, int width);
QImage imageOver(std::span<attractor::Rgba16> pixels, int width);

// Paints over the rows of the picture from `firstRow` on. Needs a QGuiApplication for the letters.
void paintOverlay(QImage& rows, const OverlayMarks& marks, int firstRow);

} // namespace io
