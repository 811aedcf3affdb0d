// SPDX-License-Identifier: MIT
#pragma once

#include "animation/paths/look_path.h"
#include "attractor/request/appearance.h"

#include <QByteArray>
#include <QByteArrayList>

#include <optional>
#include <string>
#include <vector>

// Colouring of a fractal in comment lines. Entries and keys of animations have the same lines; those of a key
// begin with "look". docs/formats.md, "Barycage's comment lines".
namespace io {

// No lines for an appearance as in a new entry.
QByteArrayList appearanceComments(const attractor::Appearance& appearance);
QByteArrayList lookComments(const animation::Look& look);

// Collects the lines of one entry or key.
class AppearanceComments {
public:
    // False when the key or its values are not understood.
    bool read(const QByteArray& key, const QByteArrayList& values);

    // The appearance as read, with the values of a new entry where no line says otherwise; the palette is the
    // usual one.
    const attractor::Appearance& appearance() const { return m_appearance; }

    bool namesPalette() const { return m_paletteName || !m_stops.empty(); }
    std::string paletteName() const { return m_paletteName.value_or(std::string()); }
    // The palette of the lines, with its stops or built in; nullopt if it is neither.
    std::optional<attractor::Palette> palette() const;

private:
    bool readStop(const QByteArrayList& values);

    attractor::Appearance m_appearance;
    std::optional<std::string> m_paletteName;
    std::vector<attractor::Palette::Stop> m_stops;
};

} // namespace io
