// SPDX-License-Identifier: MIT
#pragma once

#include "notation/value/entry.h"

#include <string>
#include <vector>

// By what an entry is held, and what of it is shown elsewhere, in comment lines. docs/formats.md, "Barycage's
// comment lines".
namespace notation {

template <int Dim> std::vector<std::string> placementLines(const Figure<Dim>& figure);

// Collects the lines of one entry.
class PlacementReader {
public:
    // False when the key is another one, or the values are not understood.
    bool read(const std::string& key, const std::vector<std::string>& values);
    // Needs the maps in place. What does not fit them is left out.
    template <int Dim> void applyTo(Figure<Dim>& figure) const;

private:
    struct Point {
        std::vector<double> coordinates;
        bool isOpen = false; // true if the last line announces further coordinates

        std::size_t dimension() const { return isOpen ? 0 : coordinates.size(); }
    };
    struct Branch {
        std::vector<int> word; // 1-based maps; 0 first: the change recurs inside itself
        std::vector<Point> by; // rows of the linear part, then the translation
    };
    static bool readPoint(const std::vector<std::string>& values, std::vector<Point>& points);
    bool readWord(const std::vector<std::string>& values);
    template <int Dim> void applyCage(Figure<Dim>& figure) const;

    std::vector<Point> m_rest;
    std::vector<Point> m_current;
    ifs::Deformation m_deformation = ifs::Deformation::Bend;
    std::vector<Branch> m_branches;
};

} // namespace notation
