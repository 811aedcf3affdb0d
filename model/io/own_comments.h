// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <QByteArrayList>
#include <QByteArrayView>
#include <QStringList>

// What a Fractint entry has no place for (cage, appearance, maps that are off) travels in comment lines
// "; barycage: key values". docs/formats.md, "Our own lines".
namespace io {

// Lines without line ends, each under 70 bytes; none when everything is as in a new entry.
QByteArrayList ownComments(const document::Fractal& fractal);

// What of `fractal` survives being written and read: maps renumbered by place, colours of maps that are gone
// dropped, texts cut to what a line can hold.
document::Fractal asStored(document::Fractal fractal);

// Whether a comment (what follows the semicolon) is one of ours, whatever its key.
bool isOwnComment(QByteArrayView comment);

// Collects the lines of one entry, then gives their values to the fractal that was read from its rows.
class OwnComments {
public:
    // False when the key or its values are not understood: such a line is kept as it is.
    bool read(QByteArrayView comment);

    // Needs the system in place. Returns a sentence for everything that did not fit it.
    QStringList applyTo(document::Fractal& fractal) const;

private:
    struct MapSetting {
        int place = 0; // 1-based
        std::optional<double> weight;
        attractor::Rgba colour;
    };
    bool readSetting(const QByteArray& key, const QByteArrayList& values);
    bool readMapSetting(const QByteArray& key, const QByteArrayList& values);
    bool readPalette(const QByteArray& key, const QByteArrayList& values);
    bool readBranch(const QByteArray& key, const QByteArrayList& values);
    void applyBranches(document::Fractal& fractal, QStringList& sentences) const;
    void applyCage(document::Fractal& fractal, QStringList& sentences) const;
    void applyPalette(document::Fractal& fractal, QStringList& sentences) const;

    struct Branch {
        std::vector<int> places;        // 1-based
        std::vector<ifs::Vector<2>> by; // rows of the linear part, then the translation
    };

    ifs::ControlCage<2> m_cage;
    std::vector<Branch> m_branches;
    attractor::Appearance m_appearance;
    std::optional<std::string> m_paletteName;
    std::vector<attractor::Palette::Stop> m_stops;
    std::vector<MapSetting> m_colours;
    std::vector<MapSetting> m_off;
    std::vector<MapSetting> m_unweighted;
    std::vector<MapSetting> m_weights;
};

} // namespace io
