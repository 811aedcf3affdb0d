// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QByteArray>
#include <QByteArrayList>
#include <QString>

#include <optional>
#include <vector>

// The group under which an entry is symmetric, in comment lines. docs/formats.md, "Barycage's comment lines".
namespace io {

// No lines without a symmetry.
template <int Dim> QByteArrayList symmetryComments(const ifs::Symmetry<Dim>& symmetry);

// Collects the lines of one entry.
class SymmetryComments {
public:
    // Returns true if the key is one of a symmetry. Errors in its values come out in applyTo(). `line` names
    // it in lines().
    bool read(const QByteArray& key, const QByteArrayList& values, std::size_t line);

    const std::vector<std::size_t>& lines() const { return m_lines; }

    // Gives the system the symmetry. Why it cannot have it, as a sentence: then its lines are to be kept.
    template <int Dim> std::optional<QString> applyTo(ifs::IteratedFunctionSystem<Dim>& system) const;

private:
    bool readNumbers(const QByteArrayList& values, std::vector<double>& numbers);

    bool m_isUnderstood = true;
    QByteArray m_name;
    std::vector<double> m_centre;
    std::vector<double> m_frame; // row by row
    std::vector<std::size_t> m_lines;
};

} // namespace io
