// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>
#include <QXmlStreamAttributes>

#include <array>
#include <optional>
#include <vector>

class QXmlStreamWriter;

// The colours of flames: <palette> or <color> elements, `background`, `contrast` and `vibrancy`, and where
// and how fast every xform pulls colours on the palette; and the names of xforms. docs/formats.md, "Flame
// XML".
namespace io {

constexpr std::size_t flameColours = 256; // colours of a palette

// Collects the settings of one flame, then applies them to the fractal that was read from it.
class FlameColourReader {
public:
    void readFlame(const QXmlStreamAttributes& attributes);  // attributes of <flame>
    void readPalette(const QString& hex, int channels);      // text of <palette>, with 3 or 4 channels
    void readColour(const QXmlStreamAttributes& attributes); // attributes of <color>: index, rgb
    void readColours(const QString& data);                   // text of <colors>: 00RRGGBB for each
    void readXform(const QXmlStreamAttributes& attributes);  // attributes of the next xform
    // Ascending: those of xforms that turned out to be no maps.
    void forgetXforms(const std::vector<std::size_t>& indices);

    // Needs the system and the name in place.
    void applyTo(document::Fractal& fractal) const;
    // Returns true if the flame names a palette of another program by its number and holds no colours.
    bool namesForeignPalette() const { return m_isForeign && m_colours.empty(); }

private:
    struct Xform {
        std::optional<double> position;
        std::optional<double> speed;
        QString name; // empty: none
    };
    void nameMaps(document::Fractal& fractal) const;
    void blendMaps(attractor::Appearance& appearance, const document::System2& system) const;
    bool colourMaps(attractor::Appearance& appearance, const document::System2& system) const;

    std::vector<attractor::Rgba> m_colours;
    std::vector<Xform> m_xforms;
    std::optional<attractor::Rgba> m_background;
    std::optional<attractor::ColourBy> m_colourBy; // value written by Barycage
    std::optional<double> m_contrast;
    std::optional<double> m_vibrancy;
    bool m_isForeign = false;
};

// The colours of a fractal as a flame shows them.
struct FlameColours {
    std::array<attractor::Rgba, flameColours> palette;
    std::vector<double> positions;             // 0 … 1, one per map
    std::vector<std::optional<double>> speeds; // one per map; nullopt: default
    bool isPalette = true;       // false: composed of the colours of the maps, which are not on the palette
    bool holdsMapColours = true; // false: more map colours than a palette holds, or map colours not shown
    bool holdsMapBlends = true;  // false: map colours take their place
};
FlameColours flameColoursOf(const document::Fractal& fractal);

// The attributes of <flame> that say how it looks.
void writeFlameLook(QXmlStreamWriter& xml, const attractor::Appearance& appearance);
// Writes the position on the palette, and the speed if the map has one of its own.
void writeFlameColour(QXmlStreamWriter& xml, const FlameColours& colours, std::size_t index);
// The name of a map of the plane as an attribute of its xform, if it has one.
void writeFlameName(QXmlStreamWriter& xml, const document::Fractal& fractal, std::size_t index);

} // namespace io
