// SPDX-License-Identifier: MIT
#pragma once

#include <QStringList>

#include <optional>
#include <vector>

namespace io {

// A map as a text writes it: its matrix, row by row, then its vector; 6 numbers in the plane, 12 in space.
struct WrittenMap {
    std::vector<double> numbers;
    std::optional<double> weight;
    int line = 0; // line of the text, 1-based
};

// A map that is written but not understood.
struct UnreadMap {
    int row = 0;  // among the maps, 1-based
    int line = 0; // line of the text, 1-based; 0 if unknown
    QString text;
};

// Maps are complete only where none is unread.
struct WrittenMaps {
    std::vector<WrittenMap> maps;
    std::optional<UnreadMap> unread{};
};

// Rows for readTable() under a header. A map in the plane among those of space makes them none.
QString tableOf(const std::vector<WrittenMap>& maps);

// The weights that stand between the maps: `between` is the text before the first, between each two, and
// behind the last. "p = 0.85", "probability 85%", "(85 %)"; or bounds of a random number, "r < 0.86". Some
// are missing where at least half of the maps have one; else none has.
std::vector<std::optional<double>> weightsBetween(const QStringList& between);

} // namespace io
