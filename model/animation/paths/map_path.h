// SPDX-License-Identifier: MIT
#pragma once

#include "animation/paths/common_norm.h"

#include <optional>

namespace animation {

// A map with its weight, as a key holds it.
template <int Dim> struct MapPose {
    ifs::AffineMap<Dim> map;
    std::optional<double> weight; // same meaning as in ifs::WeightedMap

    friend bool operator==(const MapPose&, const MapPose&) = default;
};

// Interpolates between two maps, exact at both ends: ifs::interpolated() in the coordinates of the norm,
// where the map therefore contracts as well as the worse end; the image of `reference` moves straight.
// Weights change evenly; where one of them is missing, the first one stays until the end.
template <int Dim>
MapPose<Dim> between(const MapPose<Dim>& from, const MapPose<Dim>& to, double share,
                     const ifs::Vector<Dim>& reference, const CommonNorm<Dim>& norm);

// The straight path, (1 − share)·from + share·to: it contracts in every norm in which both ends do, and folds
// or shrinks between ends that are turned against each other.
template <int Dim>
ifs::AffineMap<Dim> straight(const ifs::AffineMap<Dim>& from, const ifs::AffineMap<Dim>& to, double share);

} // namespace animation
