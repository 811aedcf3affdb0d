// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QByteArray>
#include <QByteArrayList>

#include <map>
#include <vector>

// The names and the locks of maps, in comment lines. docs/formats.md, "Barycage's comment lines".
namespace io {

// No lines without labels. A name is UTF-8, in which %HH stands for a byte; a long one goes on in the next
// line of its map.
QByteArrayList labelComments(const document::Fractal& fractal);

// The label as it comes back after being written and read.
document::MapLabel storedLabel(document::MapLabel label);

// Collects the lines of one entry.
class LabelComments {
public:
    // False when the key is another one, or the values are not understood.
    bool read(const QByteArray& key, const QByteArrayList& values);
    // Needs the system in place. Lines of maps that it does not have say nothing.
    void applyTo(document::Fractal& fractal) const;

private:
    std::map<int, QByteArray> m_names; // names as written, by 1-based map
    std::vector<int> m_locked;
};

} // namespace io
