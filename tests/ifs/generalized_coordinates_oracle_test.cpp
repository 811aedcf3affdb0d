// SPDX-License-Identifier: MIT
// Built where CGAL is installed (libcgal-dev): its coordinates were written by others and share no code with
// ours.
#include "ifs/canonical_systems.h"
#include "ifs/generalized_coordinates.h"

#include <QtTest>

#include <CGAL/Barycentric_coordinates_2/Mean_value_coordinates_2.h>
#include <CGAL/Barycentric_coordinates_2/Wachspress_coordinates_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <iterator>

using namespace ifs;
using namespace canonical;

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Corners = std::vector<Vector<2>>;

std::vector<double> theirs(Coordinates kind, const Corners& corners, const Vector<2>& x) {
    namespace other = CGAL::Barycentric_coordinates;
    std::vector<Point> polygon;
    for (const auto& corner : corners)
        polygon.emplace_back(corner.x(), corner.y());
    const Point query(x.x(), x.y());
    std::vector<double> result;
    if (kind == Coordinates::Wachspress)
        other::wachspress_coordinates_2(polygon, query, std::back_inserter(result));
    else
        other::mean_value_coordinates_2(polygon, query, std::back_inserter(result));
    return result;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double result = a.size() == b.size() ? 0 : 1;
    for (std::size_t j = 0; j < a.size() && j < b.size(); ++j)
        result = std::max(result, std::abs(a[j] - b[j]) / (1 + std::abs(b[j])));
    return result;
}

// With corners at equal or at random distances from the origin.
Corners randomPolygon(Random& random, std::size_t count, bool isConvex) {
    Corners corners;
    for (std::size_t j = 0; j < count; ++j) {
        const double angle = 2 * std::numbers::pi * (double(j) + uniform(random, -.3, .3)) / double(count);
        const double r = isConvex ? 2 : uniform(random, 1, 3);
        corners.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return corners;
}

} // namespace

class GeneralizedCoordinatesOracleTest : public QObject {
    Q_OBJECT

private slots:
    void wachspressInsideConvexPolygons() {
        Random random(1);
        for (std::size_t count = 3; count <= 24; ++count)
            for (int n = 0; n < 50; ++n) {
                const Corners corners = randomPolygon(random, count, true);
                const Vector<2> x(uniform(random, -.6, .6), uniform(random, -.6, .6));
                const auto mine = generalizedCoordinates(Coordinates::Wachspress, corners, x);
                if (std::ranges::min(mine) < 0) continue; // x is outside a polygon of few corners
                QVERIFY(difference(mine, theirs(Coordinates::Wachspress, corners, x)) < 1e-11);
            }
    }

    void meanValuesInsideStars() {
        Random random(2);
        for (std::size_t count = 4; count <= 24; ++count)
            for (int n = 0; n < 50; ++n) {
                const Corners corners = randomPolygon(random, count, false);
                const Vector<2> x(uniform(random, -.3, .3), uniform(random, -.3, .3));
                QVERIFY(difference(generalizedCoordinates(Coordinates::MeanValue, corners, x),
                                   theirs(Coordinates::MeanValue, corners, x)) < 1e-11);
            }
    }
};

QTEST_APPLESS_MAIN(GeneralizedCoordinatesOracleTest)
#include "generalized_coordinates_oracle_test.moc"
