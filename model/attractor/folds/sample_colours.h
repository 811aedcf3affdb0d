// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/cells.h"
#include "attractor/request/appearance.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// The colours of samples where an appearance gives every sample one of its own; see coloursSamples().
class SampleColours {
public:
    SampleColours() = default;
    // `ids` and `index`: of the maps that take part, and their places in the system.
    SampleColours(const Appearance& appearance, std::span<const ifs::MapId> ids,
                  std::span<const std::size_t> index);

    // The map is counted among those that take part.
    const ColourCell& of(std::uint32_t map, double addressCoordinate) const;
    // Colours of all maps, where samples have the colour of theirs; otherwise empty.
    std::span<const ColourCell> ofMaps() const { return m_byMap ? m_colours : std::span<const ColourCell>(); }

private:
    bool m_byMap = false;
    std::vector<ColourCell> m_colours; // indexed by map, or by address coordinate
};

} // namespace attractor
