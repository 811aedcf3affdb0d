// SPDX-License-Identifier: MIT
#include "collage/drawings.h"
#include "collage/fit/attractor_fit.h"
#include "collage/fit/cage_fit.h"
#include "collage/fit/collage_fit.h"
#include "collage/random_start.h"
#include "collage/suggestions.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"

#include <QTest>

#include <numbers>

using namespace collage;

namespace {

using CageMaps = std::vector<ifs::AffineMap<2>>;

// A square from four quarters of itself.
CageMaps square() {
    CageMaps maps;
    for (const double x : {0.0, 0.5})
        for (const double y : {0.0, 0.5})
            maps.push_back(ifs::affineMap(0.5, 0, 0, 0.5, x, y));
    return maps;
}

const std::vector<ifs::Vector<2>> unitSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

// The shape that lies to the left of every edge of a polygon that turns counter-clockwise.
Mask convex(int side, const std::vector<ifs::Vector<2>>& corners) {
    return drawings::drawn(side, [&](double x, double y) {
        for (std::size_t j = 0; j < corners.size(); ++j) {
            const ifs::Vector<2> from = corners[j], edge = corners[(j + 1) % corners.size()] - from;
            if (edge.x() * (y - from.y()) - edge.y() * (x - from.x()) < 0) return false;
        }
        return true;
    });
}

double turnInDegrees(const ifs::AffineMap<2>& map) {
    const ifs::Matrix<2> turn = turnOf(map.linear);
    return std::atan2(turn(1, 0), turn(0, 0)) * 180 / std::numbers::pi;
}

double stray(double angle, double step) {
    return std::abs(angle - step * std::round(angle / step));
}

Constraints everything() {
    Constraints constraints;
    constraints.mirrors = Mirrors::Excluded;
    constraints.angleStep = 60;
    constraints.first = FirstMap::Stem;
    return constraints;
}

bool meets(const CageMaps& maps, int step) {
    for (std::size_t i = 1; i < maps.size(); ++i)
        if (ifs::determinant<2>(maps[i].linear) < 0 || stray(turnInDegrees(maps[i]), step) > 1e-6)
            return false;
    const double norm = ifs::spectralNorm<2>(maps[0].linear);
    return std::abs(ifs::determinant<2>(maps[0].linear)) <= 1e-9 * norm * norm && norm > 0.05;
}

} // namespace

class CageFitTest : public QObject {
    Q_OBJECT

private slots:
    // The cage of a square comes to lie on the corners of a quadrangle.
    void cornersGoToThoseOfTheTarget() {
        const std::vector<ifs::Vector<2>> corners{{-0.8, -0.7}, {0.7, -0.5}, {0.5, 0.6}, {-0.5, 0.8}};
        const Target l = target(convex(256, corners), 1, 0.25);
        const auto fit = fittedCage(l, square(), unitSquare, ifs::Coordinates::Wachspress);
        QVERIFY(fit.has_value());
        QVERIFY2(fit->error < 1.0 / 256, qPrintable(QString::number(256 * fit->error)));
        for (std::size_t j = 0; j < corners.size(); ++j) {
            // drawn() has sides of 2 units, the plane of the target 1.
            const double distance = (fit->vertices[j] - corners[j] / 2).norm();
            QVERIFY2(distance < 4.0 / 256, qPrintable(QString::number(256 * distance)));
        }
    }

    void aStopEndsTheFit() {
        const Target l = target(convex(64, {{-0.5, -0.5}, {0.5, -0.5}, {0, 0.5}}), 1, 0.25);
        std::stop_source source;
        QVERIFY(fittedCage(l, square(), unitSquare, ifs::Coordinates::Wachspress, source.get_token()));
        source.request_stop();
        QVERIFY(!fittedCage(l, square(), unitSquare, ifs::Coordinates::Wachspress, source.get_token()));
    }

    void moreCornersFollowBetter() {
        const Mask disc = drawings::drawn(256, [](double x, double y) { return x * x + y * y < 0.6; });
        const Target l = target(disc, 1, 0.25);
        std::vector<ifs::Vector<2>> octagon{{0, 0}, {0.5, 0}, {1, 0}, {1, 0.5},
                                            {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}};
        for (ifs::Vector<2>& corner : octagon) // strictly convex around the square
            corner += 0.2 * (corner - ifs::Vector<2>(0.5, 0.5)).normalized();
        const auto four = fittedCage(l, square(), unitSquare, ifs::Coordinates::MeanValue);
        const auto eight = fittedCage(l, square(), octagon, ifs::Coordinates::MeanValue);
        QVERIFY(four && eight);
        QVERIFY2(eight->error < 0.5 * four->error, qPrintable(QString::number(eight->error / four->error)));
    }

    void holesHaveNoOuterOutline() {
        const Mask ring = drawings::drawn(64, [](double x, double y) {
            const double square = x * x + y * y;
            return square < 0.7 && square > 0.2;
        });
        const Mask outline = outerOutline(ring);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                if (!outline(x, y)) continue;
                const double u = (x + 0.5) / 32 - 1, v = (y + 0.5) / 32 - 1;
                QVERIFY(u * u + v * v > 0.5);
            }
        QVERIFY(area(outline) > 100);
    }

    void whatHasNoAttractorHasNoCage() {
        const Target l = target(convex(64, {{-0.5, -0.5}, {0.5, -0.5}, {0, 0.5}}), 1, 0.25);
        const CageMaps growing{ifs::affineMap(2, 0, 0, 2, 0, 0)};
        QVERIFY(!fittedCage(l, growing, unitSquare, ifs::Coordinates::Wachspress));
    }

    void constraintsAreMet() {
        const auto drawing = drawings::all(128).front();
        const Target l = target(drawing.mask, 2, 0.25);
        for (std::uint64_t start = 0; start < 8; ++start) {
            CageMaps maps = randomStart(l, 4, everything(), 5, start);
            QVERIFY(meets(maps, 60));
            CollageFit(l).improve(maps, {everything(), 12, 6, 0.75, 0.9});
            QVERIFY(meets(maps, 60));
            CageMaps plane;
            for (const auto& map : maps)
                plane.push_back(fromGrid(l.grid, map));
            const double before = visibleError(l, attractorAgreement(l, plane));
            plane = fittedAttractor(l, plane, {everything(), 4, 0.9});
            QVERIFY(meets(plane, 60));
            QVERIFY(visibleError(l, attractorAgreement(l, plane)) <= before * (1 + 1e-6));
        }
    }

    void suggestionsMeetThem() {
        SearchOptions options;
        options.minMaps = options.maxMaps = 4;
        options.starts = 32;
        options.constraints = everything();
        options.constraints.angleStep = 90;
        const Suggestions found = suggestions(drawings::all(96).front().mask, options);
        QVERIFY(!found.list.empty());
        for (const Suggestion& one : found.list)
            QVERIFY(meets(one.maps, 90));
    }

    void whatMeetsThemKeepsItsBits() {
        const auto map = ifs::affineMap(0.3, 0.05, 0.05, 0.4, 0.1, 0.2);
        Constraints constraints = everything();
        constraints.angleStep = 90;
        const auto same = constrained(constraints, 1, map, ifs::Vector<2>(3, 4));
        QVERIFY(same == map);
    }
};

BARYCAGE_TEST(CageFitTest);
#include "cage_fit_test.moc"
