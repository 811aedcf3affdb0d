// SPDX-License-Identifier: MIT
#include "attractor/appearance.h"

#include <algorithm>

namespace attractor {

namespace {

constexpr auto idOf = &std::pair<ifs::MapId, Rgba>::first;

} // namespace

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

Rgba mapColour(const Appearance& appearance, ifs::MapId id, std::size_t place) {
    const Rgba* own = appearance.mapColours.find(id);
    return own ? *own : categoricalColour(place);
}

} // namespace attractor
