// SPDX-License-Identifier: MIT
#include "attractor/request/appearance.h"

namespace attractor {

Appearance::Appearance() = default;
Appearance::Appearance(const Appearance& other) = default;
Appearance::Appearance(Appearance&& other) noexcept = default;
Appearance& Appearance::operator=(const Appearance& other) = default;
Appearance& Appearance::operator=(Appearance&& other) noexcept = default;
Appearance::~Appearance() = default;

bool coloursSamples(ColourBy colourBy) {
    return colourBy == ColourBy::Map || colourBy == ColourBy::Address || colourBy == ColourBy::Blend;
}

Rgba mapColour(const Appearance& appearance, ifs::MapId id, std::size_t index) {
    const Rgba* own = appearance.mapColours.find(id);
    return own ? *own : categoricalColour(index);
}

MapBlend usualBlend(std::size_t index, std::size_t maps) {
    return {maps > 1 ? static_cast<double>(index) / static_cast<double>(maps - 1) : 0};
}

MapBlend mapBlend(const Appearance& appearance, ifs::MapId id, std::size_t index, std::size_t maps) {
    const MapBlend* own = appearance.mapBlends.find(id);
    return own ? *own : usualBlend(index, maps);
}

MapBlend composed(const MapBlend& outer, const MapBlend& inner) {
    const double ofInner = (1 - outer.speed) * inner.speed;
    const double speed = outer.speed + ofInner;
    if (!(speed > 0)) return {outer.coordinate, 0};
    return {(outer.speed * outer.coordinate + ofInner * inner.coordinate) / speed, speed};
}

} // namespace attractor
