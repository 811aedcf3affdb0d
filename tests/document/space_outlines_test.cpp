// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "document/analysis/analysis.h"
#include "document/fractal/space_geometry.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace document;
using ifs::Vector;

namespace {

Fractal menger() {
    return support::fractalOf(systems::menger());
}

std::vector<SpaceOutline> shapesOf(const Fractal& fractal, std::set<Outline> outlines, int depth = 1) {
    Analyser analyser;
    return analyser.begun({std::make_shared<const Fractal>(fractal), std::move(outlines), depth, 1})
        .shapesInSpace;
}

} // namespace

class SpaceOutlinesTest : public QObject {
    Q_OBJECT

private slots:
    // Of a cube, facets of the hull in one plane are one face.
    void theHullOfTheSpongeIsACube() {
        for (const Outline kind : {Outline::Hull, Outline::Box}) {
            const auto shapes = shapesOf(menger(), {kind});
            QCOMPARE(shapes.size(), 1U);
            QCOMPARE(shapes[0].points.size(), 8U);
            QCOMPARE(shapes[0].edges.size(), 12U);
            for (const auto& [a, b] : shapes[0].edges) {
                const Vector<3> side = shapes[0].points[std::size_t(b)] - shapes[0].points[std::size_t(a)];
                QVERIFY(std::abs(side.norm() - 1) < 0.02);
                QVERIFY(std::abs(side.cwiseAbs().maxCoeff() - side.norm()) < 0.02);
            }
        }
    }

    void theSimplexHasSixEdges() {
        const auto shapes = shapesOf(menger(), {Outline::Simplex});
        QCOMPARE(shapes.size(), 1U);
        QCOMPARE(shapes[0].edges.size(), 6U);
        QVERIFY((shapes[0].points[1] - Vector<3>(3, 0, 0)).norm() < 1e-4);
    }

    // A ball of even mass has variance r²/5 along every axis; the sponge has 1/10 (its moments): r = √½.
    void theEllipsoidHasTheMomentsOfTheMass() {
        const auto shapes = shapesOf(menger(), {Outline::Ellipse});
        QCOMPARE(shapes.size(), 2U);
        for (const Vector<3>& point : shapes[0].points)
            QVERIFY(std::abs((point - Vector<3>(0.5, 0.5, 0.5)).norm() - std::sqrt(0.5)) < 1e-6);
        QVERIFY((shapes[1].points.at(0) - Vector<3>(0.5, 0.5, 0.5)).norm() < 1e-9);
    }

    void fixedPointsAndCylindersHaveTheColoursOfTheirMaps() {
        Fractal fractal = menger();
        const ifs::MapId third = system3(fractal)->maps[2].id;
        fractal.appearance.mapColours[third] = {1, 2, 3, 255};
        const auto points = shapesOf(fractal, {Outline::FixedPoints});
        QCOMPARE(points.size(), 20U);
        QCOMPARE(points[2].colour->blue, std::uint8_t(3));
        QVERIFY((points[2].points[0] - Vector<3>(0, 0, 1)).norm() < 1e-9);
        const auto cylinders = shapesOf(fractal, {Outline::Cylinders});
        QCOMPARE(cylinders.size(), 20U);
        QCOMPARE(cylinders[2].colour->blue, std::uint8_t(3));
        for (const Vector<3>& corner : cylinders[2].points)
            QVERIFY(corner.z() > 2.0 / 3 - 0.03 && corner.x() < 1.0 / 3 + 0.03);
        QCOMPARE(shapesOf(fractal, {Outline::Cylinders}, 2).size(), 400U);
        QCOMPARE(shapesOf(fractal, {Outline::Cylinders}, 9).size(), 400U); // more would not be seen
    }

    void shapesFollowTheCage() {
        Fractal moved = menger();
        auto cage = *spaceCage(moved);
        for (Vector<3>& vertex : cage.current)
            vertex = 2 * vertex + Vector<3>(5, 0, 0);
        space(moved)->cage = cage;
        for (const Outline kind : {Outline::Hull, Outline::Box}) {
            double low = 1e9, high = -1e9;
            const auto shapes = shapesOf(moved, {kind});
            for (const Vector<3>& point : shapes.at(0).points) {
                low = std::min(low, point.x());
                high = std::max(high, point.x());
            }
            QVERIFY(std::abs(low - 5) < 0.05 && std::abs(high - 7) < 0.05);
        }
        QVERIFY((shapesOf(moved, {Outline::FixedPoints}).at(19).points[0] - Vector<3>(7, 2, 2)).norm() <
                1e-9);
    }

    void degenerateSystemsHaveShapesOrNone() {
        Fractal point = menger();
        system3(point)->maps.resize(1);
        const std::set<Outline> all{Outline::Box,     Outline::Hull,        Outline::Simplex,
                                    Outline::Ellipse, Outline::FixedPoints, Outline::Cylinders};
        for (const SpaceOutline& shape : shapesOf(point, all, 4))
            for (const Vector<3>& at : shape.points)
                QVERIFY(at.allFinite());
        Fractal none = menger();
        for (auto& map : system3(none)->maps)
            map.map.linear *= 5;
        QVERIFY(shapesOf(none, {Outline::Box, Outline::Hull, Outline::Simplex, Outline::Cylinders}).empty());
        system3(none)->maps.clear();
        QVERIFY(shapesOf(none, all).empty());
    }
};

BARYCAGE_TEST(SpaceOutlinesTest, QCoreApplication);
#include "space_outlines_test.moc"
