// SPDX-License-Identifier: MIT
#include "io/exchange/flame_colours.h"

#include "document/maps/map_names.h"
#include "io/palette/palette_stops.h"
#include "io/text/number.h"

#include <QStringList>
#include <QXmlStreamWriter>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

using attractor::ColourBy;
using attractor::Palette;
using attractor::Rgba;

constexpr std::size_t last = flameColours - 1;
constexpr const char* colourByKey = "barycage_colour"; // attribute for Barycage only

struct ColourByName {
    ColourBy colourBy;
    const char* name;
};
constexpr std::array colourByNames{
    ColourByName{ColourBy::Density, "density"}, ColourByName{ColourBy::Map, "map"},
    ColourByName{ColourBy::Address, "address"}, ColourByName{ColourBy::Plain, "plain"},
    ColourByName{ColourBy::Blend, "blend"}};

// Three numbers, of which `full` is the brightest.
std::optional<Rgba> colourOf(QStringView text, double full) {
    std::array<std::uint8_t, 3> channels{};
    const auto words = text.split(u' ', Qt::SkipEmptyParts);
    if (words.size() < 3) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto value = parseNumber(words[qsizetype(i)]);
        if (!value || !std::isfinite(*value)) return std::nullopt;
        channels[i] = std::uint8_t(std::lround(std::clamp(*value / full, 0.0, 1.0) * 255));
    }
    return Rgba{channels[0], channels[1], channels[2], 255};
}

// Pairs of hexadecimal digits, whatever stands between them; `skip` of the `bytes` of each colour come first.
std::vector<Rgba> hexColours(const QString& text, std::size_t bytes, std::size_t skip) {
    const QByteArray data = QByteArray::fromHex(text.left(qsizetype(flameColours) * 64).toLatin1());
    std::vector<Rgba> colours;
    const auto level = [&](std::size_t i) { return std::uint8_t(data[qsizetype(i)]); };
    for (std::size_t i = 0; i + bytes <= std::size_t(data.size()) && colours.size() < flameColours;
         i += bytes)
        colours.push_back({level(i + skip), level(i + skip + 1), level(i + skip + 2), 255});
    return colours;
}

std::array<Rgba, flameColours> sampled(const Palette& palette) {
    std::array<Rgba, flameColours> colours;
    for (std::size_t i = 0; i < flameColours; ++i) {
        colours[i] = attractor::colourAt(palette, double(i) / double(last));
        colours[i].alpha = 255;
    }
    return colours;
}

// The palette of these colours: one of the program's own if it has exactly these.
Palette paletteThrough(const std::vector<Rgba>& colours, const QString& name) {
    for (const Palette& known : attractor::builtInPalettes())
        if (std::ranges::equal(sampled(known), colours)) return known;
    return {name.toStdString(), stopsThrough(colours)};
}

int distance(const Rgba& a, const Rgba& b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

std::size_t nearest(const std::array<Rgba, flameColours>& palette, const Rgba& colour) {
    const auto by = [&](const Rgba& a, const Rgba& b) { return distance(a, colour) < distance(b, colour); };
    return std::size_t(std::ranges::min_element(palette, by) - palette.begin());
}

// The distinct ones, in the order in which they come first.
std::vector<Rgba> distinct(const std::vector<Rgba>& colours) {
    std::vector<Rgba> found;
    for (const Rgba& colour : colours) {
        if (std::ranges::find(found, colour) == found.end()) found.push_back(colour);
        if (found.size() > flameColours) break; // more than a palette holds; the exact number is irrelevant
    }
    return found;
}

std::array<Rgba, flameColours> spread(const std::vector<Rgba>& colours, FlameColours& flame) {
    Palette palette;
    const double steps = std::max<double>(1, double(colours.size()) - 1);
    for (std::size_t i = 0; i < colours.size(); ++i)
        palette.stops.push_back({std::round(double(i) * double(last) / steps) / double(last), colours[i]});
    if (colours.size() == 1) palette.stops.push_back({1, colours.front()});
    flame.isPalette = false;
    return sampled(palette);
}

// Adds the blends that maps have been given. Colours of maps are kept if they are those of their places.
FlameColours blended(FlameColours flame, const attractor::Appearance& appearance,
                     const document::System2& system) {
    flame.holdsMapColours = appearance.colourBy == ColourBy::Blend;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const attractor::MapBlend* blend = appearance.mapBlends.find(system.maps[i].id);
        if (blend != nullptr) {
            flame.positions[i] = blend->coordinate;
            flame.speeds[i] = blend->speed;
        }
        const Rgba* colour = appearance.mapColours.find(system.maps[i].id);
        const auto place = std::size_t(std::lround(flame.positions[i] * double(last)));
        if (colour != nullptr && (blend == nullptr || distance(flame.palette[place], *colour) > 1))
            flame.holdsMapColours = false;
    }
    return flame;
}

// A number limited to 0 … 1.
std::optional<double> share(std::optional<double> number) {
    if (!number || std::isnan(*number)) return std::nullopt;
    return std::clamp(*number, 0.0, 1.0);
}

} // namespace

void FlameColourReader::readFlame(const QXmlStreamAttributes& attributes) {
    m_background = colourOf(attributes.value(QLatin1String("background")), 1);
    m_isForeign = attributes.hasAttribute(QLatin1String("palette"));
    const auto name = attributes.value(QLatin1String(colourByKey));
    for (const ColourByName& known : colourByNames)
        if (name == QLatin1String(known.name)) m_colourBy = known.colourBy;
    const auto contrast = parseNumber(attributes.value(QLatin1String("contrast")));
    if (contrast && *contrast > 0 && std::isfinite(*contrast)) m_contrast = contrast;
    const auto vibrancy = parseNumber(attributes.value(QLatin1String("vibrancy")));
    if (vibrancy && !std::isnan(*vibrancy)) m_vibrancy = std::clamp(*vibrancy, 0.0, 1.0);
}

void FlameColourReader::readPalette(const QString& hex, int channels) {
    m_colours = hexColours(hex, std::size_t(channels), 0);
}

void FlameColourReader::readColour(const QXmlStreamAttributes& attributes) {
    const auto index = parseNumber(attributes.value(QLatin1String("index")));
    const auto colour = colourOf(attributes.value(QLatin1String("rgb")), 255);
    if (!index || !colour || !(*index >= 0 && *index <= double(last))) return;
    m_colours.resize(std::max(m_colours.size(), std::size_t(*index) + 1));
    m_colours[std::size_t(*index)] = *colour;
}

void FlameColourReader::readColours(const QString& data) {
    m_colours = hexColours(data, 4, 1);
}

void FlameColourReader::readXform(const QXmlStreamAttributes& attributes) {
    // First of two coordinates in older flames, the only one in use.
    const QStringView text = attributes.value(QLatin1String("color")).trimmed();
    const qsizetype end = text.indexOf(u' ');
    const auto position = share(parseNumber(end < 0 ? text : text.first(end)));
    auto speed = share(parseNumber(attributes.value(QLatin1String("color_speed"))));
    const auto symmetry = parseNumber(attributes.value(QLatin1String("symmetry"))); // older form
    if (!speed && symmetry) speed = share((1 - *symmetry) / 2);
    m_xforms.push_back(
        {position, speed, document::mapNameOf(attributes.value(QLatin1String("name")).toString())});
}

void FlameColourReader::forgetXforms(const std::vector<std::size_t>& indices) {
    for (auto index = indices.rbegin(); index != indices.rend(); ++index)
        m_xforms.erase(m_xforms.begin() + std::ptrdiff_t(*index));
}

void FlameColourReader::nameMaps(document::Fractal& fractal) const {
    const auto name = [&](const auto& maps) {
        for (std::size_t i = 0; i < std::min(m_xforms.size(), maps.size()); ++i)
            if (!m_xforms[i].name.isEmpty()) fractal.mapLabels.set(maps[i].id, {m_xforms[i].name, false});
    };
    if (const document::System2* system = document::system2(fractal)) name(system->maps);
    if (const document::System3* solid = document::system3(fractal)) name(solid->maps);
}

// Barycage gives a place to every xform, and a speed to those of maps with a blend of their own.
void FlameColourReader::blendMaps(attractor::Appearance& appearance, const document::System2& system) const {
    if (m_colourBy == ColourBy::Map) return;
    const std::size_t count = system.maps.size();
    for (std::size_t i = 0; i < std::min(m_xforms.size(), count); ++i) {
        const Xform& xform = m_xforms[i];
        if (!xform.speed && (m_colourBy || !xform.position)) continue;
        const attractor::MapBlend usual = attractor::usualBlend(i, count);
        appearance.mapBlends[system.maps[i].id] = {xform.position.value_or(usual.coordinate),
                                                   xform.speed.value_or(usual.speed)};
    }
}

// Returns true if any map has got a colour.
bool FlameColourReader::colourMaps(attractor::Appearance& appearance, const document::System2& system) const {
    bool isAny = false;
    for (std::size_t i = 0; i < std::min(m_xforms.size(), system.maps.size()); ++i) {
        const Xform& xform = m_xforms[i];
        if (!xform.position || (m_colourBy == ColourBy::Blend && !xform.speed)) continue;
        const double position = *xform.position * double(m_colours.size() - 1);
        appearance.mapColours[system.maps[i].id] =
            m_colours[std::size_t(std::lround(position))]; // original colour, without the error of stops
        isAny = true;
    }
    return isAny;
}

void writeFlameName(QXmlStreamWriter& xml, const document::Fractal& fractal, std::size_t index) {
    const ifs::MapId id = document::system2(fractal)->maps[index].id;
    const QString name = document::mapNameOf(fractal.mapLabels.of(id).name);
    if (!name.isEmpty()) xml.writeAttribute(QStringLiteral("name"), name);
}

void FlameColourReader::applyTo(document::Fractal& fractal) const {
    nameMaps(fractal);
    attractor::Appearance& appearance = fractal.appearance;
    if (m_background) appearance.background = *m_background;
    appearance.contrast = m_contrast.value_or(appearance.contrast);
    appearance.vibrancy = m_vibrancy.value_or(appearance.vibrancy);
    const document::System2* system = document::system2(fractal);
    if (system != nullptr) blendMaps(appearance, *system);
    if (m_colours.empty()) return;
    appearance.palette = paletteThrough(m_colours, fractal.name);
    if (m_colourBy) appearance.colourBy = *m_colourBy;
    // True if places are free, because colours depend neither on maps nor on their blends.
    const bool hasPlaces = !m_colourBy || *m_colourBy == ColourBy::Map || *m_colourBy == ColourBy::Blend;
    if (system != nullptr && hasPlaces && colourMaps(appearance, *system) && !m_colourBy)
        appearance.colourBy = ColourBy::Blend;
}

FlameColours flameColoursOf(const document::Fractal& fractal) {
    const attractor::Appearance& appearance = fractal.appearance;
    const document::System2& system = *document::system2(fractal);
    FlameColours flame;
    flame.palette = sampled(appearance.palette);
    const double steps = std::max<double>(1, double(system.maps.size()) - 1);
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        flame.positions.push_back(double(i) / steps);
    flame.speeds.resize(system.maps.size());
    if (appearance.colourBy != ColourBy::Map) return blended(std::move(flame), appearance, system);
    flame.holdsMapBlends = false;
    std::vector<Rgba> colours;
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        colours.push_back(attractor::mapColour(appearance, system.maps[i].id, i));
    const std::vector<Rgba> all = distinct(colours);
    if (all.empty()) return flame;
    const bool isOnPalette = std::ranges::all_of(all, [&](const Rgba& colour) {
        return distance(flame.palette[nearest(flame.palette, colour)], colour) <= 1;
    });
    if (!isOnPalette && all.size() <= flameColours) flame.palette = spread(all, flame);
    flame.holdsMapColours = isOnPalette || all.size() <= flameColours;
    for (std::size_t i = 0; i < colours.size(); ++i)
        flame.positions[i] = double(nearest(flame.palette, colours[i])) / double(last);
    return flame;
}

void writeFlameColour(QXmlStreamWriter& xml, const FlameColours& colours, std::size_t index) {
    const auto write = [&xml](const char* name, double value) {
        xml.writeAttribute(QLatin1String(name), QString::fromLatin1(formatNumber(value)));
    };
    write("color", colours.positions[index]);
    if (colours.speeds[index]) write("color_speed", *colours.speeds[index]);
}

void writeFlameLook(QXmlStreamWriter& xml, const attractor::Appearance& appearance) {
    QByteArrayList levels;
    for (const int level :
         {appearance.background.red, appearance.background.green, appearance.background.blue})
        levels << formatNumber(level / 255.0);
    const auto write = [&xml](const char* name, const QByteArray& value) {
        xml.writeAttribute(QLatin1String(name), QString::fromLatin1(value));
    };
    write("background", levels.join(' '));
    for (const ColourByName& known : colourByNames)
        if (known.colourBy == appearance.colourBy) write(colourByKey, known.name);
    const attractor::Appearance usual; // defaults of flames without these attributes
    if (appearance.contrast != usual.contrast) write("contrast", formatNumber(appearance.contrast));
    if (appearance.vibrancy != usual.vibrancy) write("vibrancy", formatNumber(appearance.vibrancy));
}

} // namespace io
