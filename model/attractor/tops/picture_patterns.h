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
};
inline constexpr Pattern patterns[] = {Pattern::Grid, Pattern::Wheel, Pattern::Rings, Pattern::Sunset};

std::string_view nameOf(Pattern pattern); // as files store it
std::optional<Pattern> patternNamed(std::string_view name);

// Square, of side × side pixels.
MipPicture picture(Pattern pattern, int side = 1024);

} // namespace attractor
