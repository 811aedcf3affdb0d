// SPDX-License-Identifier: MIT
#include "document/fractal/fractal.h"
#include "document/fractal/fractal_geometry.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using document::Fractal;

namespace {

// The right-angled gasket on (0,0), (1,0), (0,1).
Fractal gasket() {
    document::System2 system;
    for (const ifs::Vector<2>& corner :
         {ifs::Vector<2>(0, 0), ifs::Vector<2>(0.5, 0), ifs::Vector<2>(0, 0.5)})
        ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.5, corner.x(), corner.y()), 1.0 / 3);
    return support::fractalOf(system);
}

bool isNear(const ifs::Vector<2>& a, const ifs::Vector<2>& b) {
    return (a - b).norm() < 1e-8;
}

} // namespace

class FractalTest : public QObject {
    Q_OBJECT

private slots:
    void cageInForce() {
        Fractal fractal = gasket();
        const ifs::ControlCage<2> minimal = document::effectiveCage(fractal);
        QCOMPARE(minimal.rest, minimal.current);
        QVERIFY(isNear(minimal.rest[0], {0, 0}) && isNear(minimal.rest[1], {1, 0}) &&
                isNear(minimal.rest[2], {0, 1}));
        document::plane(fractal)->cage =
            ifs::cageAtRest<2>({ifs::Vector<2>(1, 1), ifs::Vector<2>(2, 1), ifs::Vector<2>(1, 3)});
        QCOMPARE(document::effectiveCage(fractal), *document::plane(fractal)->cage);
        Fractal expanding;
        expanding.shape = document::Shape<2>{
            document::System2{{{ifs::MapId(1), ifs::affineMap(2, 0, 0, 2, 0, 0), 1, true}}}};
        QVERIFY(ifs::isValid(document::effectiveCage(expanding)));
        QVERIFY(ifs::isValid(document::effectiveCage(Fractal())));
    }

    void codeInEffect() {
        Fractal fractal = gasket();
        QCOMPARE(document::effectiveSystem(fractal), std::optional(*document::system2(fractal)));
        document::plane(fractal)->cage = document::effectiveCage(fractal);
        for (auto& vertex : document::plane(fractal)->cage->current)
            vertex = 2 * vertex + ifs::Vector<2>(1, 0);
        const auto doubled = document::effectiveSystem(fractal);
        QVERIFY(doubled.has_value());
        QVERIFY(isNear(doubled->maps[1].map.translation, {1.5, 0})); // fixes (3, 0), the image of (1, 0)
        document::plane(fractal)->cage->current[2] =
            document::plane(fractal)->cage->current[1]; // flat: the picture is seen, the code is not
        QVERIFY(!document::effectiveSystem(fractal));
        QVERIFY(!document::effectiveSystem(Fractal()));
    }

    void boxOfThePicture() {
        Fractal fractal = gasket();
        const auto box = document::displayedBox(fractal);
        QVERIFY(box && isNear(box->min, {0, 0}) && isNear(box->max, {1, 1}));
        document::plane(fractal)->cage = document::effectiveCage(fractal);
        document::plane(fractal)->cage->current = {{0, 0}, {3, 1}, {-1, 2}};
        const auto placed = document::displayedBox(fractal);
        QVERIFY(placed && isNear(placed->min, {-1, 0}) && isNear(placed->max, {3, 2}));
        document::plane(fractal)->cage->current = {{0, 0}, {1, 1}, {2, 2}}; // flat is still somewhere
        const auto flat = document::displayedBox(fractal);
        QVERIFY(flat && isNear(flat->max, {2, 2}));
        QVERIFY(!document::displayedBox(Fractal()));
    }

    void requestCarriesEverything() {
        Fractal fractal = gasket();
        document::plane(fractal)->cage = document::effectiveCage(fractal);
        fractal.appearance.gamma = 3;
        attractor::Camera camera;
        camera.width = 7;
        const attractor::RenderRequest request = document::renderRequest(fractal, camera);
        QCOMPARE(request.system, *document::system2(fractal));
        QVERIFY(request.cage == document::plane(fractal)->cage);
        QCOMPARE(request.appearance.gamma, 3.0);
        QCOMPARE(request.camera.width, 7);
        QVERIFY(document::renderRequest(Fractal(), camera).system.maps.empty());
    }

    void shapes() {
        Fractal fractal = gasket();
        QVERIFY(document::plane(fractal) && !document::space(fractal));
        QCOMPARE(document::system2(fractal), &document::plane(fractal)->system);
        QVERIFY(!document::system3(fractal) && !document::cage2(fractal));
        document::plane(fractal)->cage = document::effectiveCage(fractal);
        QVERIFY(document::cage2(fractal) == &*document::plane(fractal)->cage);

        Fractal inSpace = fractal;
        inSpace.shape =
            document::Shape<3>{{}, ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})};
        QCOMPARE(document::dimension(inSpace), 3);
        QVERIFY(!document::plane(inSpace) && document::space(inSpace));
        QCOMPARE(document::system3(inSpace), &document::space(inSpace)->system);
        QVERIFY(!document::system2(inSpace) && !document::cage2(inSpace));

        const Fractal unreadable;
        QVERIFY(!document::plane(unreadable) && !document::space(unreadable));
        QVERIFY(!document::system2(unreadable) && !document::system3(unreadable));
        QVERIFY(!document::cage2(unreadable));
    }

    void sameSystems() {
        const Fractal plane = gasket();
        Fractal placed = plane;
        document::plane(placed)->cage = document::effectiveCage(plane);
        Fractal changed = plane;
        document::system2(changed)->maps[0].map.translation.x() = 7;
        Fractal space;
        space.shape = document::Shape<3>();
        Fractal empty;
        empty.shape = document::Shape<2>();
        QVERIFY(document::isSameSystem(plane, placed) && plane != placed);
        QVERIFY(!document::isSameSystem(plane, changed));
        QVERIFY(document::isSameSystem(space, space) && document::isSameSystem(Fractal(), Fractal()));
        QVERIFY(!document::isSameSystem(space, empty) && !document::isSameSystem(empty, space));
        QVERIFY(!document::isSameSystem(empty, Fractal()));
    }

    void newFractal() {
        const Fractal fractal = document::sierpinskiTriangle();
        QCOMPARE(document::dimension(fractal), 2);
        const auto box = document::displayedBox(fractal);
        QVERIFY(box && isNear(box->max - box->min, {1, std::sqrt(3.0) / 2})); // equilateral, side 1
        QCOMPARE(document::dimension(Fractal()), 0);
    }
};

BARYCAGE_TEST(FractalTest);
#include "fractal_test.moc"
