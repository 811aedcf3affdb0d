// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "animation/transport.h"

#include <optional>
#include <span>
#include <vector>

namespace animation {

constexpr std::size_t maxMorphMaps = 256; // largest number of maps of each code

// The pairing by which the maps of one code become those of another. docs/mathematics.md, "Morphs".
template <int Dim> struct Correspondence {
    ifs::Vector<Dim> reference; // mean of both measures together
    Eigen::MatrixXd cost;       // cost per unit of weight from map i of the first code to map k of the second
    std::vector<Shipment> pairs; // active maps only
    double total = 0;            // cost of all pairs
};

// Two maps of the two codes, by their indices, that belong together as far as their weights allow.
struct Pin {
    std::size_t from = 0;
    std::size_t to = 0;
};

// Solves the optimal transport between the weights. nullopt when the invariant measure of one of the codes
// has no covariance, or there are more than maxMorphMaps.
template <int Dim>
std::optional<Correspondence<Dim>> correspondence(const ifs::ActiveMaps<Dim>& from,
                                                  const ifs::ActiveMaps<Dim>& to,
                                                  std::span<const Pin> pins = {});

// Maps with constant weights, one for each pair, as they are at the first frame, and the animation that leads
// them to the other code: at frame 0 the attractor and its measure are those of the one code, at `length`
// those of the other.
template <int Dim> struct Morph {
    ifs::IteratedFunctionSystem<Dim> system;
    Animation<Dim> animation;
};
template <int Dim>
Morph<Dim> morph(const ifs::ActiveMaps<Dim>& from, const ifs::ActiveMaps<Dim>& to,
                 const Correspondence<Dim>& correspondence, int length);

} // namespace animation
