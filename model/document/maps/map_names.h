// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

#include <cstddef>

// The names that maps are given: docs/decisions/0026.
namespace document {

inline constexpr qsizetype maxMapName = 120; // UTF-16 units

// The text as the name of a map: in one line, without control characters and marks that change the direction
// of text, cut to maxMapName.
QString mapNameOf(const QString& text);

// "3", or "3 (stem)" where the map has a name.
QString mapTitle(const Fractal& fractal, std::size_t index);

} // namespace document
