// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"
#include "attractor/request/orbit_camera.h"
#include "attractor/request/space_appearance.h"

#include <limits>
#include <vector>

namespace attractor {

enum class Look {
    Stone,   // light from the upper left, cool shade
    Ink,     // dark creases on a light ground, for print
    Depth,   // near white, far black
    Normals, // red to the right, green up, blue towards the eye; (n + 1)/2 of the full scale
};

// A unit vector in the camera's axes: to the right, up, towards the eye.
struct ViewVector {
    float right = 0;
    float up = 0;
    float towards = 1;

    friend bool operator==(const ViewVector&, const ViewVector&) = default;
};

// The direction at these angles from the line of sight, in degrees: azimuth to the right, elevation up; (0,
// 0) is the eye itself. The same bits on every machine.
ViewVector lampAt(double azimuth, double elevation);

// Settings that turn the keys of a solid into colours.
struct SolidAppearance {
    Look look = Look::Stone;
    SolidColour colourBy = SolidColour::Plain; // Map and Address: same as the key of the raster
    Palette palette = builtInPalettes().front();
    std::vector<Rgba> mapColours;     // colours of maps 0, 1, 2 …; further maps take categoricalColour()
    Rgba plain{226, 214, 196, 255};   // alpha is ignored
    Rgba background{13, 16, 23, 255}; // alpha 0: transparent
    ViewVector keyLight = lampAt(-40, 40);
    double fog = 0; // ≥ 0; points at `far` keep exp(−fog) of their colour

    friend bool operator==(const SolidAppearance&, const SolidAppearance&) = default;
};

// A look as it is when one chooses it: Ink with a white ground and a dark plain colour.
SolidAppearance appearanceOf(Look look);

// The properties of the camera on which the light depends.
struct SolidView {
    double unitsPerPixel = 1;   // world units, in the plane of the target
    ViewVector upward{0, 1, 0}; // upward direction of the scene
    // Distance to the target; infinite: orthographic.
    double eyeDistance = std::numeric_limits<double>::infinity();
    double eyeShift = 0; // same meaning as in SpaceRequest
    double lowest = -1;  // palette range: heights over the target, in units of the system
    double highest = 1;
};

// The view of a camera in a world whose y points up, the palette running between these values of y.
SolidView solidView(const OrbitCamera& camera, double lowest, double highest);

} // namespace attractor
