// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/mip_picture.h"
#include "ifs/names.h"

#include <array>
#include <span>

namespace attractor {

// Pictures that need no file.
enum class Pattern {
    Grid,   // coloured cells: red grows to the right, green upwards
    Wheel,  // all hues about the middle
    Rings,  // even rings about the middle
    Sunset, // a sky with a sun over hills
    Glass,  // panes of coloured glass between lead
    Marble, // veins in a warm stone
    Tartan, // woven stripes
    Waves,  // a rough sea under a pale sky
};
inline constexpr Pattern patterns[] = {Pattern::Grid,  Pattern::Wheel,  Pattern::Rings,  Pattern::Sunset,
                                       Pattern::Glass, Pattern::Marble, Pattern::Tartan, Pattern::Waves};

// Square, of side × side pixels.
MipPicture picture(Pattern pattern, int side = 1024);

} // namespace attractor

template <>
inline constexpr auto ifs::names<attractor::Pattern> = std::to_array<ifs::Named<attractor::Pattern>>({
    {attractor::Pattern::Grid, "grid"},
    {attractor::Pattern::Wheel, "wheel"},
    {attractor::Pattern::Rings, "rings"},
    {attractor::Pattern::Sunset, "sunset"},
    {attractor::Pattern::Glass, "glass"},
    {attractor::Pattern::Marble, "marble"},
    {attractor::Pattern::Tartan, "tartan"},
    {attractor::Pattern::Waves, "waves"},
});
