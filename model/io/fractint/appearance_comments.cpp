// SPDX-License-Identifier: MIT
#include "io/fractint/appearance_comments.h"

#include "attractor/request/appearance_fields.h"
#include "io/palette/palette_stops.h"
#include "io/text/metadata_line.h"
#include "io/text/number.h"
#include "notation/lines/space_lines.h"

#include <span>

namespace io {

namespace {

using attractor::Appearance, attractor::AppearanceNumber;

constexpr std::size_t maxStops = 4096; // limit against malicious files
constexpr const char* beforeLook = "look ";

QByteArrayList paletteLines(const QByteArray& before, const attractor::Palette& palette) {
    QByteArrayList lines{metadataLine(before + "palette", QByteArray::fromStdString(palette.name))};
    const attractor::Palette* builtIn = attractor::findPalette(palette.name);
    if (builtIn != nullptr && *builtIn == palette) return lines;
    for (const auto& stop : palette.stops)
        lines << metadataLine(before + "stop", formatNumber(stop.position) + ' ' + colourText(stop.colour));
    return lines;
}

// The lines of an entry; those of a key are `before`, and say more of what is usual.
QByteArrayList commonLines(const Appearance& appearance, const QByteArray& before, bool isKey) {
    const Appearance usual;
    QByteArrayList lines;
    if (isKey || appearance.colourBy != usual.colourBy)
        lines << metadataLine(before + "colour-by", ifs::nameOf(appearance.colourBy));
    if (isKey || !(appearance.palette == usual.palette)) lines << paletteLines(before, appearance.palette);
    for (const auto& [key, colour] : attractor::appearanceColours)
        if (isKey || !(appearance.*colour == usual.*colour))
            lines << metadataLine(before + key, colourText(appearance.*colour));
    for (const AppearanceNumber& number : attractor::appearanceNumbers) {
        const bool isStored = isKey && number.inKeys == AppearanceNumber::InKeys::Always;
        if (isStored || appearance.*number.member != usual.*number.member)
            lines << metadataLine(before + number.key, formatNumber(appearance.*number.member));
    }
    return lines;
}

} // namespace

QByteArrayList appearanceComments(const Appearance& appearance) {
    QByteArrayList lines = commonLines(appearance, {}, false);
    if (appearance.supersample != Appearance().supersample)
        lines << metadataLine("supersample", QByteArray::number(appearance.supersample));
    return lines;
}

QByteArrayList lookComments(const animation::Look& look) {
    QByteArrayList lines = commonLines(look, beforeLook, true);
    if (!look.inSpace) return lines;
    if (look.inSpace->look == attractor::SpaceAppearance().look) // at least one line
        lines << metadataLine("look space-look", ifs::nameOf(look.inSpace->look));
    return lines << byteLines(notation::spaceLines(*look.inSpace, beforeLook));
}

bool AppearanceComments::read(const QByteArray& key, const QByteArrayList& values) {
    if (key == "palette") { // name optional
        m_paletteName = values.join(' ').toStdString();
        return true;
    }
    if (key == "stop") return readStop(values);
    if (values.size() != 1) return false;
    if (key == "colour-by") {
        const auto colourBy = ifs::named<attractor::ColourBy>(values[0].toStdString());
        m_appearance.colourBy = colourBy.value_or(m_appearance.colourBy);
        return colourBy.has_value();
    }
    for (const auto& [known, member] : attractor::appearanceColours)
        if (key == known) {
            const auto colour = parseColour(values[0]);
            m_appearance.*member = colour.value_or(m_appearance.*member);
            return colour.has_value();
        }
    const auto value = metadataNumber(values[0]);
    if (!value) return false;
    for (const AppearanceNumber& number : attractor::appearanceNumbers)
        if (key == number.key && number.accepts(*value)) {
            m_appearance.*number.member = *value;
            return true;
        }
    if (key != "supersample" || !(*value >= 1 && *value <= 4) || *value != static_cast<int>(*value))
        return false;
    m_appearance.supersample = static_cast<int>(*value);
    return true;
}

bool AppearanceComments::readStop(const QByteArrayList& values) {
    if (values.size() != 2 || m_stops.size() >= maxStops) return false;
    const auto position = metadataNumber(values[0]);
    const auto colour = parseColour(values[1]);
    if (!position || !colour || *position < 0 || *position > 1) return false;
    m_stops.push_back({*position, *colour});
    return true;
}

std::optional<attractor::Palette> AppearanceComments::palette() const {
    const std::string name = paletteName();
    if (isGradient(m_stops)) return attractor::Palette{name, m_stops};
    const attractor::Palette* builtIn = m_stops.empty() ? attractor::findPalette(name) : nullptr;
    return builtIn ? std::optional(*builtIn) : std::nullopt;
}

} // namespace io
