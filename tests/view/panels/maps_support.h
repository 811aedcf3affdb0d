// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "ifs/canonical_systems.h"
#include "support/fractals.h"

#include <QTest>

#include <array>
#include <vector>

// Fractals and documents for the tests of the panels.
namespace maps_support {

using Row = std::array<double, 7>; // a b c d e f p

inline document::Fractal fractalWith(document::System2 system) {
    return support::fractalOf(std::move(system), QStringLiteral("test"));
}

inline document::Fractal fractalOf(const std::vector<Row>& rows) {
    document::System2 system;
    for (const Row& r : rows)
        ifs::append(system, ifs::affineMap(r[0], r[1], r[2], r[3], r[4], r[5]), r[6]);
    return fractalWith(std::move(system));
}

inline document::Fractal maple() {
    return fractalWith(canonical::system(canonical::maple(), {0.25, 0.25, 0.25, 0.25}));
}

inline document::Fractal withTriangle(document::Fractal fractal) {
    ifs::ControlCage<2> cage;
    cage.rest = {{-3, -3}, {5, -3}, {-3, 6}};
    cage.current = cage.rest;
    document::plane(fractal)->cage = std::move(cage);
    return fractal;
}

// The fern of canonical::fern3(), each map as likely as any other.
inline document::Fractal fernInSpace() {
    document::System3 system;
    for (const auto& map : canonical::fern3())
        ifs::append(system, map, 0.25);
    document::Fractal fractal;
    fractal.name = QStringLiteral("fern3");
    fractal.shape = document::Shape<3>{std::move(system)};
    return fractal;
}

// Held by the tetrahedron (0, 0, 0), (8, 0, 0), (0, 8, 0), (0, 0, 8).
inline document::Fractal withTetrahedron(document::Fractal fractal) {
    document::space(fractal)->cage = ifs::polygonAtRest<3>({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}});
    return fractal;
}

inline const document::System3& solidOf(const document::Document& document) {
    return *document::system3(document.fractal());
}

inline const document::System2& systemOf(const document::Document& document) {
    return *document::system2(document.fractal());
}

inline double distance(const ifs::AffineMap<2>& a, const ifs::AffineMap<2>& b) {
    return (a.linear - b.linear).norm() + (a.translation - b.translation).norm();
}

} // namespace maps_support
