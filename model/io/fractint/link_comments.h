// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <QByteArray>
#include <QByteArrayList>
#include <QString>

#include <cstddef>
#include <map>
#include <vector>

// The links of maps, in comment lines. docs/formats.md, "Barycage's comment lines".
namespace io {

// The rows of the matrix that are not all 1, each behind the number of its map.
template <int Dim> QByteArrayList linkComments(const ifs::IteratedFunctionSystem<Dim>& system);

// Collects the lines of one entry.
class LinkComments {
public:
    // False when the key is another one, or the values are not understood. `line` tells the line apart from
    // the others of the entry.
    bool read(const QByteArray& key, const QByteArrayList& values, std::size_t line);

    struct Outcome {
        QString sentence;  // sentence about links that do not fit the system; empty: all do
        bool kept = false; // true if the lines stay as they are
    };
    // Needs the symmetry in place.
    template <int Dim> Outcome applyTo(ifs::IteratedFunctionSystem<Dim>& system) const;

    const std::vector<std::size_t>& lines() const { return m_lines; }

private:
    std::map<int, std::vector<double>> m_rows; // rows by 1-based map
    std::vector<std::size_t> m_lines;
};

} // namespace io
