// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QTest>

#include <array>
#include <vector>

// Fractals and documents for the tests of the panels.
namespace maps_support {

using Row = std::array<double, 7>; // a b c d e f p

inline document::Fractal fractalOf(const std::vector<Row>& rows) {
    document::System2 system;
    for (const Row& r : rows)
        ifs::append(system, ifs::affineMap(r[0], r[1], r[2], r[3], r[4], r[5]), r[6]);
    document::Fractal fractal;
    fractal.name = QStringLiteral("test");
    fractal.system = std::move(system);
    return fractal;
}

inline document::Fractal maple() {
    return fractalOf({{-0.04, 0, -0.23, -0.65, -0.08, 0.26, 0.25},
                      {0.61, 0, 0, 0.31, 0.07, 3.5, 0.25},
                      {0.65, 0.29, -0.3, 0.48, 0.74, 0.39, 0.25},
                      {0.64, -0.3, 0.16, 0.56, -0.56, 0.60, 0.25}});
}

inline document::Fractal withTriangle(document::Fractal fractal) {
    ifs::ControlCage<2> cage;
    cage.rest = {{-3, -3}, {5, -3}, {-3, 6}};
    cage.current = cage.rest;
    fractal.cage = std::move(cage);
    return fractal;
}

inline const document::System2& systemOf(const document::Document& document) {
    return *document::system2(document.fractal());
}

inline double distance(const ifs::AffineMap<2>& a, const ifs::AffineMap<2>& b) {
    return (a.linear - b.linear).norm() + (a.translation - b.translation).norm();
}

} // namespace maps_support
