// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QByteArray>
#include <QByteArrayList>

#include <map>
#include <vector>

// Pull of maps on palette coordinates, in comment lines. docs/formats.md, "Barycage's comment lines".
namespace io {

// "map-blend N COORDINATE SPEED" for every map that has been given a blend.
QByteArrayList blendComments(const document::Fractal& fractal);

// Collects the lines of one entry.
class BlendComments {
public:
    // False when the key is another one, or the values are not understood.
    bool read(const QByteArray& key, const QByteArrayList& values);
    // Needs the system in place. Lines of maps that it does not have say nothing.
    void applyTo(document::Fractal& fractal) const;

private:
    std::map<int, std::vector<double>> m_blends; // coordinate and speed by 1-based map
};

} // namespace io
