// SPDX-License-Identifier: MIT
#include "io/fractint/space_comments.h"

#include "io/text/metadata_line.h"
#include "io/text/number.h"

#include <cmath>
#include <limits>

namespace io {

namespace {

using attractor::LookInSpace;
using attractor::SolidColour;

constexpr const char* open = "-"; // mark of an open side of the clip
constexpr double infinite = std::numeric_limits<double>::infinity();

QByteArray bound(double value) {
    return std::isfinite(value) ? formatNumber(value) : QByteArray(open);
}

} // namespace

QByteArrayList spaceComments(const attractor::SpaceAppearance& appearance, const QByteArray& before) {
    const attractor::SpaceAppearance standard;
    QByteArrayList lines;
    const auto add = [&](const char* key, const QByteArrayList& values) {
        lines << metadataLines(before + key, values);
    };
    if (appearance.look != standard.look) add("space-look", {ifs::nameOf(appearance.look)});
    if (appearance.colourBy) add("solid-colour", {ifs::nameOf(*appearance.colourBy)});
    if (appearance.lightAzimuth != standard.lightAzimuth ||
        appearance.lightElevation != standard.lightElevation)
        add("light", {formatNumber(appearance.lightAzimuth), formatNumber(appearance.lightElevation)});
    if (appearance.fog != standard.fog) add("fog", {formatNumber(appearance.fog)});
    if (!appearance.clip) return lines;
    const attractor::SpaceClip& clip = *appearance.clip;
    QByteArrayList normal;
    for (int i = 0; i < 3; ++i)
        normal << formatNumber(clip.normal[i]);
    add("clip-normal", normal);
    add("clip-range", {bound(clip.lowest), bound(clip.highest)});
    return lines;
}

bool SpaceComments::read(const QByteArray& key, const QByteArrayList& values) {
    if (values.isEmpty()) return false;
    if (key == "space-look") {
        const auto look = ifs::named<LookInSpace>(values[0].toStdString());
        m_appearance.look = look.value_or(m_appearance.look);
        return look && values.size() == 1;
    }
    if (key == "solid-colour") {
        const auto colour = ifs::named<SolidColour>(values[0].toStdString());
        if (colour) m_appearance.colourBy = colour;
        return colour && values.size() == 1;
    }
    if (key == "light") {
        const auto azimuth = metadataNumber(values[0]), elevation = metadataNumber(values.back());
        if (values.size() != 2 || !azimuth || !elevation) return false;
        m_appearance.lightAzimuth = *azimuth;
        m_appearance.lightElevation = *elevation;
        return true;
    }
    if (key == "fog") {
        const auto fog = metadataNumber(values[0]);
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
    for (const QByteArray& value : values) {
        const bool isOpen = isRange && value == open;
        const auto read = isOpen ? std::optional(into.empty() ? -infinite : infinite) : metadataNumber(value);
        if (!read || into.size() == most) return false;
        into.push_back(*read);
    }
    (isRange ? m_range : m_normal) = into;
    return true;
}

attractor::SpaceAppearance SpaceComments::appearance() const {
    attractor::SpaceAppearance result = m_appearance;
    if (m_normal.size() != 3 || m_range.size() != 2) return result;
    const attractor::SpaceClip clip{{m_normal[0], m_normal[1], m_normal[2]}, m_range[0], m_range[1]};
    if (isUsable(clip)) result.clip = clip;
    return result;
}

} // namespace io
