// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/mip_picture.h"

#include <optional>
#include <span>
#include <string_view>

namespace attractor {

// Pictures that need no file.
enum class Pattern {
    Grid,   // numbered by colour: red grows to the right, green upwards
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

std::string_view nameOf(Pattern pattern); // as files store it
std::optional<Pattern> patternNamed(std::string_view name);

// Square, of side × side pixels.
MipPicture picture(Pattern pattern, int side = 1024);

} // namespace attractor
