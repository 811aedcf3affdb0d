// SPDX-License-Identifier: MIT
#include "attractor/appearance.h"

namespace attractor {

Rgba mapColour(const Appearance& appearance, ifs::MapId id, std::size_t place) {
    const auto own = appearance.mapColours.find(id);
    return own != appearance.mapColours.end() ? own->second : categoricalColour(place);
}

} // namespace attractor
