// SPDX-License-Identifier: MIT
#include "notation/lines/space_lines.h"

#include "notation/text/number.h"
#include "notation/text/words.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace notation {

namespace {

using attractor::LookInSpace;
using attractor::SolidColour;

constexpr std::string_view openSide = "-"; // mark of an open side of the clip
constexpr double infinite = std::numeric_limits<double>::infinity();

std::string bound(double value) {
    return std::isfinite(value) ? formatNumber(value) : std::string(openSide);
}

} // namespace

std::vector<std::string> spaceLines(const attractor::SpaceAppearance& appearance, std::string_view before) {
    const attractor::SpaceAppearance standard;
    std::vector<std::string> lines;
    const auto add = [&](const char* key, const std::vector<std::string>& values) {
        append(lines, ownLines(std::string(before) + key, values));
    };
    if (appearance.look != standard.look) add("space-look", {ifs::nameOf(appearance.look)});
    if (appearance.colourBy) add("solid-colour", {ifs::nameOf(*appearance.colourBy)});
    if (appearance.lightAzimuth != standard.lightAzimuth ||
        appearance.lightElevation != standard.lightElevation)
        add("light", {formatNumber(appearance.lightAzimuth), formatNumber(appearance.lightElevation)});
    if (appearance.fog != standard.fog) add("fog", {formatNumber(appearance.fog)});
    if (!appearance.clip) return lines;
    const attractor::SpaceClip& clip = *appearance.clip;
    std::vector<std::string> normal;
    for (int i = 0; i < 3; ++i)
        normal.push_back(formatNumber(clip.normal[i]));
    add("clip-normal", normal);
    add("clip-range", {bound(clip.lowest), bound(clip.highest)});
    return lines;
}

bool SpaceReader::read(const std::string& key, const std::vector<std::string>& values) {
    if (values.empty()) return false;
    if (key == "space-look") {
        const auto look = ifs::named<LookInSpace>(values[0]);
        m_appearance.look = look.value_or(m_appearance.look);
        return look && values.size() == 1;
    }
    if (key == "solid-colour") {
        const auto colour = ifs::named<SolidColour>(values[0]);
        if (colour) m_appearance.colourBy = colour;
        return colour && values.size() == 1;
    }
    if (key == "light") {
        const auto azimuth = parseNumber(values[0]), elevation = parseNumber(values.back());
        if (values.size() != 2 || !azimuth || !elevation) return false;
        m_appearance.lightAzimuth = *azimuth;
        m_appearance.lightElevation = *elevation;
        return true;
    }
    if (key == "fog") {
        const auto fog = parseNumber(values[0]);
        if (values.size() != 1 || !fog || !(*fog >= 0 && *fog <= attractor::SpaceAppearance::maxFog))
            return false;
        m_appearance.fog = *fog;
        return true;
    }
    const bool isRange = key == "clip-range";
    if (!isRange && key != "clip-normal") return false;
    // Copy, so that a line counts as a whole or not at all.
    std::vector<double> into = isRange ? m_range : m_normal;
    const std::size_t most = isRange ? 2 : 3;
    for (const std::string& value : values) {
        const bool isOpen = isRange && value == openSide;
        const auto read = isOpen ? std::optional(into.empty() ? -infinite : infinite) : parseNumber(value);
        if (!read || into.size() == most) return false;
        into.push_back(*read);
    }
    (isRange ? m_range : m_normal) = into;
    return true;
}

attractor::SpaceAppearance SpaceReader::appearance() const {
    attractor::SpaceAppearance result = m_appearance;
    if (m_normal.size() != 3 || m_range.size() != 2) return result;
    const attractor::SpaceClip clip{{m_normal[0], m_normal[1], m_normal[2]}, m_range[0], m_range[1]};
    if (isUsable(clip)) result.clip = clip;
    return result;
}

} // namespace notation
