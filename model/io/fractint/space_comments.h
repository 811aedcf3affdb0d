// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/space_appearance.h"

#include <QByteArray>
#include <QByteArrayList>

#include <optional>
#include <vector>

// Appearance of an entry in space, in comment lines. docs/formats.md, "Barycage's comment lines".
namespace io {

// No lines for an appearance as in a new entry. `before` is put before the key of every line.
QByteArrayList spaceComments(const attractor::SpaceAppearance& appearance, const QByteArray& before = {});

// Collects the lines of one entry.
class SpaceComments {
public:
    // False when the key or its values are not understood.
    bool read(const QByteArray& key, const QByteArrayList& values);

    // The appearance as read; a clip that makes no sense is left out.
    attractor::SpaceAppearance appearance() const;

private:
    attractor::SpaceAppearance m_appearance;
    std::vector<double> m_normal;
    std::vector<double> m_range; // infinite on open sides
};

} // namespace io
