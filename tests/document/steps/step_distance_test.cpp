// SPDX-License-Identifier: MIT
#include "document/steps/step_distance.h"

#include "document/fractal/fractal_geometry.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace document;

namespace {

const double high = std::sqrt(3.0) / 2;

// With equal sides, held by its corners.
Fractal equilateral() {
    Shape<2> shape;
    const std::vector<ifs::Vector<2>> corners{{0, 0}, {1, 0}, {0.5, high}};
    for (const ifs::Vector<2>& corner : corners) {
        ifs::AffineMap<2> map;
        map.linear = 0.5 * ifs::Matrix<2>::Identity();
        map.translation = corner / 2;
        ifs::append(shape.system, map);
    }
    shape.cage = ifs::polygonAtRest<2>(corners);
    Fractal fractal;
    fractal.shape = shape;
    return fractal;
}

} // namespace

class StepDistanceTest : public QObject {
    Q_OBJECT

private slots:
    // The farthest point of the triangle from the attractor is the middle of the triangle that is missing in
    // it, whose incircle has radius √3/12; every step halves it.
    void isTheIncircleOfTheMissingTriangle() {
        for (int n = 0; n <= 5; ++n) {
            const auto found = stepDistance(equilateral(), nullptr, n, {});
            QVERIFY(found && found->distance && found->bound);
            QCOMPARE(found->contraction, 0.5);
            const double exact = std::sqrt(3.0) / 12 / std::pow(2, n);
            QVERIFY2(std::abs(*found->distance - exact) < 2.5 * found->cell,
                     qPrintable(QStringLiteral("%1: %2, not %3").arg(n).arg(*found->distance).arg(exact)));
            QVERIFY(*found->distance <= *found->bound);
            QVERIFY(!found->isOfCode);
        }
    }

    // B in ten times the size is that much farther; the bound follows from the first distance.
    void isThatOfWhatIsDisplayed() {
        Fractal large = equilateral();
        for (auto& corner : plane(large)->cage->current)
            corner *= 10;
        const auto found = stepDistance(large, nullptr, 1, {});
        QVERIFY(found && std::abs(*found->distance - 10 * std::sqrt(3.0) / 24) < 2.5 * found->cell);
    }

    void aShapeIsOverTheAttractor() {
        const StartShape square = squareShape();
        const auto first = stepDistance(equilateral(), &square, 0, {});
        const auto third = stepDistance(equilateral(), &square, 3, {});
        QVERIFY(first && third);
        // The upper corners of the square around the triangle are 1/2 from its edges' images in the attractor
        // at least, and 0.52 from its top.
        QVERIFY(*first->distance > 0.4 && *first->distance < 0.53);
        QVERIFY(std::abs(*third->bound - *first->bound / 8) < 1e-12);
        QVERIFY(*third->distance <= *third->bound);
    }

    void withoutContractionNothingIsPromised() {
        Fractal fractal = equilateral();
        plane(fractal)->system.maps[1].map.linear *= 2.5;
        const auto found = stepDistance(fractal, nullptr, 2, {});
        QVERIFY(found && !found->distance && !found->bound);
        QCOMPARE(found->contraction, 1.25);
    }

    void bentPicturesAreMeasuredAtRest() {
        Fractal fractal = equilateral();
        plane(fractal)->cage->current = {{0, 0}, {1, 0}, {2, 0}}; // flat
        const auto found = stepDistance(fractal, nullptr, 0, {});
        QVERIFY(found && found->isOfCode);
        QVERIFY(std::abs(*found->distance - std::sqrt(3.0) / 12) < 2.5 * found->cell);
    }

    void endsWhenStopped() {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!stepDistance(equilateral(), nullptr, 3, stop.get_token()));
        QVERIFY(!stepDistance({}, nullptr, 3, {})); // an unreadable entry
    }
};

BARYCAGE_TEST(StepDistanceTest, QCoreApplication);
#include "step_distance_test.moc"
