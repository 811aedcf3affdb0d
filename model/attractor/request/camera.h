// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

namespace attractor {

enum class YAxis { Up, Down };

// The visible part of the plane, independent of the raster that shows it. A value.
struct View {
    ifs::Vector<2> centre = ifs::Vector<2>::Zero(); // world point in the middle
    double height = 1;                              // > 0, world units from the lower edge to the upper one
    YAxis yAxis = YAxis::Up;                        // Up: mathematics and Fractint; Down: window coordinates
    double rotation = 0; // radians in (−π, π]; counter-clockwise rotation of the picture on the screen

    friend bool operator==(const View&, const View&) = default;
};

// Pixels.
struct RasterSize {
    int width = 0;
    int height = 0;

    friend bool operator==(const RasterSize&, const RasterSize&) = default;
};

// A view on a raster. A value; pixel (0,0) is the top left corner of the top left pixel.
struct Camera {
    ifs::Vector<2> centre = ifs::Vector<2>::Zero(); // world point in the middle of the picture
    double pixelsPerUnit = 100;                     // > 0
    int width = 0;                                  // pixels
    int height = 0;
    YAxis yAxis = YAxis::Up;
    double rotation = 0; // same meaning as in View

    friend bool operator==(const Camera&, const Camera&) = default;
};

// The view at the scale at which its height fills the raster, and back. A camera needs a height for that.
Camera cameraOf(const View& view, RasterSize size);
View viewOf(const Camera& camera);

// Conversion between a rotation and the degrees shown to people and stored in files: rounded to a millionth,
// and in (−180, 180]. A round trip is exact.
double rotationOf(double degrees);
double degreesOf(double rotation);

// The rotation as it acts on offsets on the screen, in pixels with y down. The identity for 0, and exact for
// quarter turns.
ifs::Matrix<2> screenTurn(double rotation);

// World → pixel coordinates, and back.
ifs::AffineMap<2> worldToPixel(const Camera& camera);
ifs::Vector<2> toPixel(const Camera& camera, const ifs::Vector<2>& world);
ifs::Vector<2> toWorld(const Camera& camera, const ifs::Vector<2>& pixel);

// The camera of the same size, direction and rotation that shows the box [min, max] with a margin of `margin`
// times the picture on each side. A box without extent is shown at a scale of its own.
Camera fitted(Camera camera, const ifs::Vector<2>& min, const ifs::Vector<2>& max, double margin = 0.05);

// Zooms by `factor`; the world point under `pixel` stays where it is.
Camera zoomedAt(Camera camera, const ifs::Vector<2>& pixel, double factor);

// Turns by `angle`, counter-clockwise on the screen; the world point under `pixel` stays where it is.
Camera rotatedAt(Camera camera, const ifs::Vector<2>& pixel, double angle);

// Pans so that the point seen at `pixel` is seen at `pixel + delta`.
Camera panned(Camera camera, const ifs::Vector<2>& delta);

} // namespace attractor
