// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"
#include "attractor/request/space_appearance.h"

#include <optional>

namespace animation {

// The appearance that a key holds. The colours and blends of single maps and the supersampling are those of
// the entry, and have their usual values here.
struct Look : attractor::Appearance {
    std::optional<attractor::SpaceAppearance> inSpace; // nullopt: appearance of the entry

    friend bool operator==(const Look&, const Look&) = default;
};

Look lookOf(const attractor::Appearance& appearance,
            const std::optional<attractor::SpaceAppearance>& inSpace = {});
attractor::Appearance withLook(attractor::Appearance appearance, const Look& look);

// Interpolates between two looks, exact at both ends: colours in Oklab, palettes at every position where
// either has a stop, numbers on the scale of their row of appearanceNumbers. The meaning of the colours
// changes at the end. In space the light turns the shorter way, and light, fog and clip planes move evenly;
// the kind of look, and a clip that only one of the looks has, change at the end.
Look between(const Look& from, const Look& to, double share);

// The palette gone round by a share of a cycle, 0 ≤ … < 1: once to its end and back, so that no colour meets
// another one at a seam.
attractor::Palette cycled(const attractor::Palette& palette, double share);

} // namespace animation
