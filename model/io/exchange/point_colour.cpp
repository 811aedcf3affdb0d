// SPDX-License-Identifier: MIT
#include "io/exchange/point_colour.h"

namespace io {

attractor::Rgba pointColour(const attractor::Appearance& appearance, ifs::MapId id, std::size_t map,
                            double colourCoordinate) {
    switch (appearance.colourBy) {
    case attractor::ColourBy::Map:
        return attractor::mapColour(appearance, id, map);
    case attractor::ColourBy::Address:
    case attractor::ColourBy::Blend:
        return attractor::colourAt(appearance.palette, colourCoordinate);
    case attractor::ColourBy::Plain:
        return appearance.plain;
    case attractor::ColourBy::Density:
        break;
    }
    return attractor::colourAt(appearance.palette, 0.75);
}

} // namespace io
