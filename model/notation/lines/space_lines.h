// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/space_appearance.h"

#include <string>
#include <string_view>
#include <vector>

// Appearance of an entry in space, in comment lines. docs/formats.md, "Barycage's comment lines".
namespace notation {

// No lines for an appearance as in a new entry. `before` is put before the key of every line.
std::vector<std::string> spaceLines(const attractor::SpaceAppearance& appearance,
                                    std::string_view before = {});

// Collects the lines of one entry.
class SpaceReader {
public:
    // False when the key or its values are not understood.
    bool read(const std::string& key, const std::vector<std::string>& values);

    // The appearance as read; a clip that makes no sense is left out.
    attractor::SpaceAppearance appearance() const;

private:
    attractor::SpaceAppearance m_appearance;
    std::vector<double> m_normal;
    std::vector<double> m_range; // infinite where a side is open
};

} // namespace notation
