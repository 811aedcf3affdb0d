// SPDX-License-Identifier: MIT
#include "notation/lines/look_lines.h"

#include "attractor/request/appearance_fields.h"
#include "notation/text/number.h"
#include "notation/text/words.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace notation {

namespace {

constexpr std::size_t maxStops = 4096; // limit against malicious files

std::optional<attractor::Rgba> colourOf(std::string_view text) {
    if (text.size() != 9 || text.front() != '#') return std::nullopt;
    if (text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string_view::npos) return std::nullopt;
    std::uint32_t all = 0;
    std::from_chars(text.data() + 1, text.data() + text.size(), all, 16);
    const auto channel = [all](int shift) { return std::uint8_t(all >> shift); };
    return attractor::Rgba{channel(24), channel(16), channel(8), channel(0)};
}

// In order of position, from 0 to 1.
bool isWholeGradient(const std::vector<attractor::Palette::Stop>& stops) {
    return stops.size() >= 2 && stops.front().position == 0 && stops.back().position == 1 &&
           std::ranges::is_sorted(stops, {}, &attractor::Palette::Stop::position);
}

ifs::MapId idAt(std::size_t index) {
    return ifs::MapId(std::uint32_t(index) + 1);
}

} // namespace

std::string colourText(const attractor::Rgba& colour) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t channel : {colour.red, colour.green, colour.blue, colour.alpha}) {
        text += digits[channel >> 4];
        text += digits[channel & 15];
    }
    return text;
}

std::vector<std::string> appearanceLines(const attractor::Appearance& appearance) {
    const attractor::Appearance usual;
    std::vector<std::string> lines;
    if (appearance.colourBy != usual.colourBy)
        lines.push_back(ownLine("colour-by", ifs::nameOf(appearance.colourBy)));
    if (const attractor::Palette& palette = appearance.palette; !(palette == usual.palette)) {
        lines.push_back(ownLine("palette", palette.name));
        const attractor::Palette* builtIn = attractor::findPalette(palette.name);
        if (builtIn == nullptr || !(*builtIn == palette))
            for (const auto& stop : palette.stops)
                lines.push_back(ownLine("stop", formatNumber(stop.position) + ' ' + colourText(stop.colour)));
    }
    for (const auto& [key, colour] : attractor::appearanceColours)
        if (!(appearance.*colour == usual.*colour))
            lines.push_back(ownLine(key, colourText(appearance.*colour)));
    for (const attractor::AppearanceNumber& number : attractor::appearanceNumbers)
        if (appearance.*number.member != usual.*number.member)
            lines.push_back(ownLine(number.key, formatNumber(appearance.*number.member)));
    if (appearance.supersample != usual.supersample)
        lines.push_back(ownLine("supersample", std::to_string(appearance.supersample)));
    return lines;
}

// Two lines where the numbers are too long for one, as in the links of maps.
std::vector<std::string> mapBlendLines(const attractor::Appearance& appearance, std::size_t maps) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < maps && !appearance.mapBlends.empty(); ++i) {
        const auto* blend = appearance.mapBlends.find(idAt(i));
        if (!blend) continue;
        const std::string number = std::to_string(i + 1) + ' ';
        const std::string coordinate = formatNumber(blend->coordinate), speed = formatNumber(blend->speed);
        const std::string line = ownLine("map-blend", number + coordinate + ' ' + speed);
        if (line.size() <= maxOwnLine)
            lines.push_back(line);
        else
            append(lines, {ownLine("map-blend", number + coordinate), ownLine("map-blend", number + speed)});
    }
    return lines;
}

bool LookReader::read(const std::string& key, const std::vector<std::string>& values) {
    if (key == "palette") { // name optional
        m_paletteName = joined(values);
        return true;
    }
    if (key == "stop") return readStop(values);
    if (key == "map-colour") return readMapColour(values);
    if (key == "map-blend") return readMapBlend(values);
    if (values.size() != 1) return false;
    if (key == "colour-by") {
        const auto colourBy = ifs::named<attractor::ColourBy>(values[0]);
        m_appearance.colourBy = colourBy.value_or(m_appearance.colourBy);
        return colourBy.has_value();
    }
    for (const auto& [known, member] : attractor::appearanceColours)
        if (key == known) {
            const auto colour = colourOf(values[0]);
            m_appearance.*member = colour.value_or(m_appearance.*member);
            return colour.has_value();
        }
    return readNumber(key, values[0]);
}

bool LookReader::readNumber(const std::string& key, const std::string& text) {
    const auto value = parseNumber(text);
    if (!value) return false;
    for (const attractor::AppearanceNumber& number : attractor::appearanceNumbers)
        if (key == number.key && number.accepts(*value)) {
            m_appearance.*number.member = *value;
            return true;
        }
    if (key != "supersample" || !(*value >= 1 && *value <= 4) || *value != int(*value)) return false;
    m_appearance.supersample = int(*value);
    return true;
}

bool LookReader::readStop(const std::vector<std::string>& values) {
    if (values.size() != 2 || m_stops.size() >= maxStops) return false;
    const auto position = parseNumber(values[0]);
    const auto colour = colourOf(values[1]);
    if (!position || !colour || *position < 0 || *position > 1) return false;
    m_stops.push_back({*position, *colour});
    return true;
}

bool LookReader::readMapColour(const std::vector<std::string>& values) {
    const auto colour = values.size() == 2 ? colourOf(values[1]) : std::nullopt;
    if (!colour || wholeNumber(values[0]) < 1) return false;
    m_colours.emplace_back(wholeNumber(values[0]), *colour);
    return true;
}

bool LookReader::readMapBlend(const std::vector<std::string>& values) {
    if (values.size() < 2 || values.size() > 3 || wholeNumber(values[0]) < 1) return false;
    std::vector<double> numbers;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const auto number = parseNumber(values[i]);
        if (!number || !(*number >= 0 && *number <= 1)) return false;
        numbers.push_back(*number);
    }
    const int map = wholeNumber(values[0]);
    const auto known = m_blends.find(map);
    if (known != m_blends.end() && known->second.size() + numbers.size() > 2) return false;
    std::vector<double>& blend = m_blends[map];
    blend.insert(blend.end(), numbers.begin(), numbers.end());
    return true;
}

std::optional<attractor::Palette> LookReader::palette() const {
    const std::string name = m_paletteName.value_or(std::string());
    if (isWholeGradient(m_stops)) return attractor::Palette{name, m_stops};
    const auto* builtIn = m_stops.empty() ? attractor::findPalette(name) : nullptr;
    return builtIn ? std::optional(*builtIn) : std::nullopt;
}

attractor::Appearance LookReader::appearance(std::size_t maps) const {
    attractor::Appearance result = m_appearance;
    result.palette = palette().value_or(result.palette);
    auto colours = m_colours;
    std::ranges::stable_sort(colours, {}, &std::pair<int, attractor::Rgba>::first); // the last one counts
    for (const auto& [map, colour] : colours)
        if (std::size_t(map) <= maps) result.mapColours[idAt(std::size_t(map) - 1)] = colour;
    for (const auto& [map, numbers] : m_blends) {
        if (std::size_t(map) > maps) break;
        attractor::MapBlend& blend = result.mapBlends[idAt(std::size_t(map) - 1)];
        blend.coordinate = numbers.front();
        if (numbers.size() > 1) blend.speed = numbers.back();
    }
    return result;
}

} // namespace notation
