// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QByteArray>

#include <optional>
#include <span>
#include <vector>

namespace io {

// "#rrggbbaa", lower case.
QByteArray colourText(const attractor::Rgba& colour);
std::optional<attractor::Rgba> parseColour(const QByteArray& text);

// Returns true for stops in order of position, from 0 to 1.
bool isGradient(const std::vector<attractor::Palette::Stop>& stops);

// Few stops whose gradient passes every one of these evenly spaced colours within
// one of 256 levels. One colour gives an even palette.
std::vector<attractor::Palette::Stop> stopsThrough(std::span<const attractor::Rgba> colours);

} // namespace io
