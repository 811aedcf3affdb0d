// SPDX-License-Identifier: MIT
#include "attractor/folds/sample_colours.h"

#include "attractor/colour/srgb_transfer.h"

#include <algorithm>

namespace attractor {

namespace {

constexpr std::size_t addressColours = 1024;

ColourCell colourCell(const Rgba& colour) {
    const auto channel = [](std::uint8_t code) {
        return static_cast<std::uint32_t>(linearLight(code) * 4095 + 0.5);
    };
    return {1, channel(colour.red), channel(colour.green), channel(colour.blue)};
}

} // namespace

SampleColours::SampleColours(const Appearance& appearance, std::span<const ifs::MapId> ids,
                             std::span<const std::size_t> index)
    : m_byMap(appearance.colourBy == ColourBy::Map) {
    if (m_byMap)
        for (std::size_t i = 0; i < ids.size(); ++i)
            m_colours.push_back(colourCell(mapColour(appearance, ids[i], index[i])));
    if (appearance.colourBy == ColourBy::Address || appearance.colourBy == ColourBy::Blend)
        for (std::size_t i = 0; i < addressColours; ++i)
            m_colours.push_back(
                colourCell(colourAt(appearance.palette, (static_cast<double>(i) + 0.5) / addressColours)));
}

const ColourCell& SampleColours::of(std::uint32_t map, double addressCoordinate) const {
    if (m_byMap) return m_colours[map];
    const auto at = static_cast<std::size_t>(addressCoordinate * static_cast<double>(addressColours));
    return m_colours[std::min(at, addressColours - 1)];
}

} // namespace attractor
