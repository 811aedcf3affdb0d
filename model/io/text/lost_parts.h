// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

#include <optional>

namespace io {

// The parts of a fractal beside its code that a form of text has a place for.
struct KeptParts {
    bool palette = false;
    bool background = false;
    bool colourBy = false;
    bool mapColours = false;
    bool tones = false;    // contrast and vibrancy
    bool symmetry = false; // group, in place of the maps it stands for
    bool links = false;
    bool transformation = false; // partner, order, mode and picture
    bool mapNames = false;
    bool mapBlends = false;
};

// The lost parts, in sentences; nullopt when nothing is lost, or only values as in a new entry.
std::optional<QString> lossBeside(const KeptParts& kept, const document::Fractal& fractal);

} // namespace io
