// SPDX-License-Identifier: MIT
#pragma once

#include "animation/motions/motion.h"

#include <span>

namespace animation {

// Ways to sway, by their English names; a user sees them translated.
struct SwayPreset {
    const char* name;
    double strength; // degrees
    std::span<const Wave> waves;
};

// Breeze, Gusts, Storm, Under Water, Breathing and Weave, which is the paper's own: one sine for all maps
// (Darmanto).
std::span<const SwayPreset> swayPresets();

template <int Dim> Sway<Dim> swayOf(const SwayPreset& preset, MapIds maps, const ifs::Vector<Dim>& root) {
    Sway<Dim> sway;
    sway.maps = std::move(maps);
    sway.strength = preset.strength;
    sway.root = root;
    sway.waves.assign(preset.waves.begin(), preset.waves.end());
    return sway;
}

} // namespace animation
