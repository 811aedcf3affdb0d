// SPDX-License-Identifier: MIT
#include "attractor/request/appearance.h"

#include <algorithm>

namespace attractor {

namespace {

constexpr auto idOf = &std::pair<ifs::MapId, Rgba>::first;

} // namespace

bool coloursSamples(ColourBy colourBy) {
    return colourBy == ColourBy::Map || colourBy == ColourBy::Address;
}

const Rgba* MapColours::find(ifs::MapId id) const {
    const auto found = std::ranges::lower_bound(m_colours, id, {}, idOf);
    return found != m_colours.end() && found->first == id ? &found->second : nullptr;
}

Rgba& MapColours::operator[](ifs::MapId id) {
    const bool isLast = m_colours.empty() || m_colours.back().first < id;
    auto found = isLast ? m_colours.end() : std::ranges::lower_bound(m_colours, id, {}, idOf);
    if (found == m_colours.end() || found->first != id) found = m_colours.insert(found, {id, Rgba{}});
    return found->second;
}

Rgba mapColour(const Appearance& appearance, ifs::MapId id, std::size_t index) {
    const Rgba* own = appearance.mapColours.find(id);
    return own ? *own : categoricalColour(index);
}

} // namespace attractor
