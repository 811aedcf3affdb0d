// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/names.h"
#include "ifs/system/affine_map.h"

#include <array>
#include <limits>
#include <optional>

namespace attractor {

// Looks of an entry in space.
enum class LookInSpace {
    Stone,   // solid, lit from the upper left
    Ink,     // solid with dark creases, for print
    Cloud,   // density of the measure, as in the plane
    XRay,    // density, coloured by mean depth
    Depth,   // near white, far black
    Normals, // direction of the surface as a colour
};

bool showsCloud(LookInSpace look); // true for densities, false for solids

enum class SolidColour {
    Plain,
    Map,     // colour of the first map of the address
    Address, // palette along the address coordinate
    Height,  // palette along the scene's upward direction
    Depth,   // palette from the nearest depth to the farthest
};

// The visible part of a picture in space: lowest ≤ ⟨normal, x⟩ ≤ highest, x as displayed. A slice between two
// planes, or a half-space where one of them is infinite.
struct SpaceClip {
    ifs::Vector<3> normal = ifs::Vector<3>::UnitX();
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();

    friend bool operator==(const SpaceClip&, const SpaceClip&) = default;
};
// Returns true if the normal is finite and not zero, and lowest ≤ highest with one of them finite.
bool isUsable(const SpaceClip& clip);

// The appearance in space only; colours and background are those of Appearance.
struct SpaceAppearance {
    static constexpr double maxFog = 100;

    LookInSpace look = LookInSpace::Stone;
    // Solids only; nullopt: Map if the cloud is coloured by map, else Plain.
    std::optional<SolidColour> colourBy;
    double lightAzimuth = -40; // degrees from the line of sight to the key light: lampAt()
    double lightElevation = 40;
    double fog = 0; // 0 … maxFog
    std::optional<SpaceClip> clip;

    friend bool operator==(const SpaceAppearance&, const SpaceAppearance&) = default;
};

} // namespace attractor

template <>
inline constexpr auto ifs::names<attractor::LookInSpace> = std::to_array<ifs::Named<attractor::LookInSpace>>({
    {attractor::LookInSpace::Stone, "stone"},
    {attractor::LookInSpace::Ink, "ink"},
    {attractor::LookInSpace::Cloud, "cloud"},
    {attractor::LookInSpace::XRay, "x-ray"},
    {attractor::LookInSpace::Depth, "depth"},
    {attractor::LookInSpace::Normals, "normals"},
});

template <>
inline constexpr auto ifs::names<attractor::SolidColour> = std::to_array<ifs::Named<attractor::SolidColour>>({
    {attractor::SolidColour::Plain, "none"},
    {attractor::SolidColour::Map, "map"},
    {attractor::SolidColour::Address, "address"},
    {attractor::SolidColour::Height, "height"},
    {attractor::SolidColour::Depth, "depth"},
});
