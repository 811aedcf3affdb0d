// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// How an entry is coloured, in comment lines. docs/formats.md, "Barycage's comment lines".
namespace notation {

std::string colourText(const attractor::Rgba& colour); // "#rrggbbaa", lower case

// None where everything is as in a new entry; the ids of its maps are 1 to `maps`.
std::vector<std::string> appearanceLines(const attractor::Appearance& appearance);
std::vector<std::string> mapBlendLines(const attractor::Appearance& appearance, std::size_t maps);

// Collects the lines of one entry.
class LookReader {
public:
    // False when the key is another one, or the values are not understood.
    bool read(const std::string& key, const std::vector<std::string>& values);
    // Of an entry with so many maps, whose ids are 1, 2, …
    attractor::Appearance appearance(std::size_t maps) const;
    // That of the lines, with its stops or built in; nullopt if it is neither.
    std::optional<attractor::Palette> palette() const;

private:
    bool readNumber(const std::string& key, const std::string& value);
    bool readStop(const std::vector<std::string>& values);
    bool readMapColour(const std::vector<std::string>& values);
    bool readMapBlend(const std::vector<std::string>& values);

    attractor::Appearance m_appearance;
    std::optional<std::string> m_paletteName;
    std::vector<attractor::Palette::Stop> m_stops;
    std::vector<std::pair<int, attractor::Rgba>> m_colours; // colours by 1-based map
    std::map<int, std::vector<double>> m_blends;            // coordinate and speed by 1-based map
};

} // namespace notation
