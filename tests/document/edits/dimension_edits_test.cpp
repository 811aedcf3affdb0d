// SPDX-License-Identifier: MIT
#include "document/edits/dimension_edits.h"
#include "document/fractal/space_geometry.h"
#include "ifs/canonical_systems.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>

// From the plane to space and back.
class DimensionEditsTest : public QObject {
    Q_OBJECT

private slots:
    void liftedMapsActOnZ();
    void aLiftedCageMovesAlike();
    void aThinTriangleBecomesATetrahedron();
    void whatCannotBeLifted();
    void flatteningUndoesLifting();
    void projectionsAreThoseOfThePoints_data();
    void projectionsAreThoseOfThePoints();
    void aTurnedLineIsRefused();
    void theCageIsBakedFirst();
};

namespace {

document::Fractal planeOf(const canonical::Maps2& maps) {
    return support::fractalOf(canonical::system(maps), QStringLiteral("plane"));
}

document::Fractal spaceOf(const canonical::Maps3& maps) {
    return support::fractalOf(canonical::system(maps), QStringLiteral("space"));
}

} // namespace

void DimensionEditsTest::liftedMapsActOnZ() {
    const auto lifted = document::lifted(planeOf(canonical::maple()));
    QVERIFY(lifted.has_value());
    const auto& maps = document::system3(*lifted)->maps;
    const auto& flat = canonical::maple();
    QCOMPARE(maps.size(), flat.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const ifs::Matrix<3>& a = maps[i].map.linear;
        QVERIFY(a.topLeftCorner(2, 2) == flat[i].linear);
        QVERIFY(a(0, 2) == 0 && a(1, 2) == 0 && a(2, 0) == 0 && a(2, 1) == 0);
        QVERIFY(std::abs(a(2, 2) - std::sqrt(std::abs(flat[i].linear.determinant()))) < 1e-15);
        QVERIFY(maps[i].map.translation ==
                ifs::Vector<3>(flat[i].translation.x(), flat[i].translation.y(), 0));
    }
    const auto typed = document::lifted(planeOf(canonical::maple()), 0.25);
    for (const auto& map : document::system3(*typed)->maps)
        QCOMPARE(map.map.linear(2, 2), 0.25);
}

void DimensionEditsTest::aLiftedCageMovesAlike() {
    document::Fractal fractal = planeOf(canonical::sierpinskiRight());
    ifs::ControlCage<2> cage = ifs::polygonAtRest<2>({{0, 0}, {2, 0}, {0, 1}});
    cage.current = {{1, 1}, {4, 2}, {0, 3}};
    document::plane(fractal)->cage = cage;
    const auto lifted = document::lifted(fractal);
    QVERIFY(lifted && document::space(*lifted)->cage);
    const ifs::AffineMap<2> flat = ifs::displayMap(cage);
    const ifs::AffineMap<3> solid = ifs::displayMap(*document::space(*lifted)->cage);
    QVERIFY((solid.linear.topLeftCorner(2, 2) - flat.linear).norm() < 1e-12);
    QVERIFY(std::abs(solid.linear(2, 2) - std::sqrt(std::abs(flat.linear.determinant()))) < 1e-12);
    QVERIFY(std::abs(solid.linear(0, 2)) + std::abs(solid.linear(2, 0)) + std::abs(solid.translation.z()) <
            1e-12);
}

void DimensionEditsTest::aThinTriangleBecomesATetrahedron() {
    document::Fractal fractal = planeOf(canonical::sierpinskiRight());
    document::plane(fractal)->cage = ifs::polygonAtRest<2>({{0, 0}, {2, 0}, {0, 2e-6}});
    const auto lifted = document::lifted(fractal);
    QVERIFY(lifted && document::space(*lifted)->cage);
    QVERIFY(ifs::isValid(*document::space(*lifted)->cage));
}

void DimensionEditsTest::whatCannotBeLifted() {
    QVERIFY(document::liftObstacle(spaceOf(canonical::tetrahedron())).contains(u"plane"));
    QVERIFY(!document::lifted(spaceOf(canonical::tetrahedron())));
    document::Fractal bent = planeOf(canonical::square());
    ifs::ControlCage<2> cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    document::plane(bent)->cage = cage;
    QVERIFY(document::lifted(bent).has_value()); // at rest it holds nothing that would be lost
    cage.current[2] = {2, 2};
    document::plane(bent)->cage = cage;
    QVERIFY(document::liftObstacle(bent).contains(u"corners"));
    QVERIFY(!document::lifted(bent));
}

void DimensionEditsTest::flatteningUndoesLifting() {
    const document::Fractal plane = planeOf(canonical::fern());
    for (const double length : {2.0, 1e308, 1e-320}) {
        const auto back = document::flattened(*document::lifted(plane), {0, 0, length});
        QVERIFY(back.has_value());
        QVERIFY(document::isSameSystem(*back, plane));
    }
}

void DimensionEditsTest::projectionsAreThoseOfThePoints_data() {
    QTest::addColumn<QList<double>>("direction");
    QTest::addColumn<QList<double>>("right");
    QTest::addColumn<QList<double>>("up");
    const double d = std::sqrt(0.5);
    QTest::newRow("z") << QList<double>{0, 0, 1} << QList<double>{1, 0, 0} << QList<double>{0, 1, 0};
    QTest::newRow("x") << QList<double>{3, 0, 0} << QList<double>{0, 0, -1} << QList<double>{0, 1, 0};
    QTest::newRow("y") << QList<double>{0, 1, 0} << QList<double>{1, 0, 0} << QList<double>{0, 0, -1};
    QTest::newRow("-y") << QList<double>{0, -1, 0} << QList<double>{1, 0, 0} << QList<double>{0, 0, 1};
    QTest::newRow("xz") << QList<double>{1, 0, 1} << QList<double>{d, 0, -d} << QList<double>{0, 1, 0};
}

void DimensionEditsTest::projectionsAreThoseOfThePoints() {
    QFETCH(QList<double>, direction);
    QFETCH(QList<double>, right);
    QFETCH(QList<double>, up);
    const ifs::Vector<3> u(right[0], right[1], right[2]), v(up[0], up[1], up[2]);
    const document::Fractal solid = spaceOf(canonical::cube());
    const auto projection = document::flattened(solid, {direction[0], direction[1], direction[2]});
    QVERIFY(projection.has_value());
    canonical::Random random(5);
    const auto& maps3 = document::system3(solid)->maps;
    const auto& maps2 = document::system2(*projection)->maps;
    QCOMPARE(maps2.size(), maps3.size());
    for (std::size_t i = 0; i < maps3.size(); ++i) {
        const ifs::Vector<3> x = canonical::randomVector<3>(random);
        const ifs::Vector<3> image = maps3[i].map(x);
        const ifs::Vector<2> flat = maps2[i].map(ifs::Vector<2>(u.dot(x), v.dot(x)));
        QVERIFY((flat - ifs::Vector<2>(u.dot(image), v.dot(image))).norm() < 1e-14);
        QCOMPARE(maps2[i].id, maps3[i].id);
    }
}

void DimensionEditsTest::aTurnedLineIsRefused() {
    const document::Fractal fern = spaceOf(canonical::fern3());
    QVERIFY(document::flattenObstacle(fern, {0, 0, 1}).contains(u"Map 2"));
    QVERIFY(!document::flattened(fern, {0, 0, 1}));
    QVERIFY(document::flattenObstacle(fern, {0, 0, 0}).contains(u"direction"));
    QVERIFY(document::flattenObstacle(planeOf(canonical::fern()), {0, 0, 1}).contains(u"space"));
}

void DimensionEditsTest::theCageIsBakedFirst() {
    document::Fractal fractal = spaceOf(canonical::tetrahedron());
    ifs::ControlCage<3> cage = ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    cage.current = {{1, 2, 3}, {3, 2, 3}, {1, 5, 3}, {2, 2, 4}};
    document::space(fractal)->cage = cage;
    const auto projection = document::flattened(fractal, {0, 0, 1});
    QVERIFY(projection.has_value());
    const auto& maps = document::system2(*projection)->maps;
    for (std::size_t i = 0; i < maps.size(); ++i) { // each fixes the projection of its corner
        const ifs::Vector<2> corner = cage.current[i].head(2);
        QVERIFY((maps[i].map(corner) - corner).norm() < 1e-12);
    }
    cage.current = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    document::space(fractal)->cage = cage;
    QVERIFY(document::flattenObstacle(fractal, {0, 0, 1}).contains(u"cage"));
}

BARYCAGE_TEST(DimensionEditsTest, QCoreApplication);
#include "dimension_edits_test.moc"
