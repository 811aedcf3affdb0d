// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <QByteArray>
#include <QByteArrayList>
#include <QString>

#include <cstddef>
#include <vector>

// Coefficients as they were typed, in comment lines. docs/formats.md, "Barycage's comment lines".
namespace io {

inline constexpr std::size_t maxTypedLines =
    100'000; // lines of an entry, whose total is limited; further ones are left out

template <int Dim> QByteArrayList typedComments(const ifs::IteratedFunctionSystem<Dim>& system);

// The coefficients as they come back after being written and read, in at most `left` lines, which are counted
// down.
template <int Dim> ifs::TypedCoefficients storedTyped(const ifs::WeightedMap<Dim>& map, std::size_t& left);

// Collects the lines of one entry.
class TypedComments {
public:
    // False when the key is another one, or the values are not understood.
    bool read(const QByteArray& key, const QByteArrayList& values);
    // Needs the maps in place. Lines of maps and columns that it does not have, and of numbers that another
    // program has changed, say nothing.
    template <int Dim> void applyTo(ifs::IteratedFunctionSystem<Dim>& system) const;

private:
    struct Line {
        std::size_t map = 0; // 1-based
        int which = 0;
        QString text;
    };
    std::vector<Line> m_lines;
};

} // namespace io
