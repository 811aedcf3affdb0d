// SPDX-License-Identifier: MIT
#include "collage/measure/agreement.h"
#include "document/edits/collage_edits.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace document;

namespace {

constexpr int side = 512, edge = 56; // of the picture, and of the white around a black square

TracedPicture square(const std::optional<Box>& onto = {}) {
    collage::GreyPicture picture{side, side, {}, {}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const bool isInside = std::min(x, y) >= edge && std::max(x, y) < side - edge;
            picture.grey.push_back(isInside ? 0 : 255);
            picture.opacity.push_back(255);
        }
    return *tracedPicture(picture, {}, onto);
}

// Four quarters of the square, each turned, moved and a little too large or too small.
Fractal quarters() {
    Fractal fractal;
    Shape<2> shape;
    constexpr double quarter = (side - 2 * edge) / 4.0 / side;
    double off = 0.03;
    for (const double x : {-quarter, quarter})
        for (const double y : {-quarter, quarter}) {
            const double scale = 0.5 + off;
            ifs::append<2>(shape.system, ifs::affineMap(scale, 0.03, -0.02, scale, x + off / 2, y - off));
            off = -1.2 * off;
        }
    fractal.shape = std::move(shape);
    return fractal;
}

double meanDistance(const Fractal& fractal, const TracedPicture& traced) {
    return collage::collageMeasure(traced.target, collageMaps(fractal)->maps).images.mean;
}

} // namespace

class CollageEditsTest : public QObject {
    Q_OBJECT

private slots:
    // A cell of the coarsest level is as large as 8 pixels: what is left comes from the finer ones.
    void mapsAreRefinedToAFractionOfAPixel() {
        const TracedPicture traced = square();
        const double before = meanDistance(quarters(), traced);
        QVERIFY2(before > 0.5, qPrintable(QString::number(before)));
        const auto refined = withMapsRefined(quarters(), traced, {});
        QVERIFY(refined);
        const double after = meanDistance(*refined, traced);
        QVERIFY2(after < 0.2, qPrintable(QStringLiteral("%1 → %2").arg(before).arg(after)));
    }

    // In the middle of a box, and as large as fits in; what is told in pixels stays.
    void aTargetLiesAsLargeAsTheFractal() {
        const Box box{{3, -10}, {23, 40}};
        const TracedPicture traced = square(box), units = square();
        QCOMPARE(traced.mask.cells, units.mask.cells);
        ifs::Vector<2> low(1e9, 1e9), high(-1e9, -1e9);
        for (const auto& corner : traced.outlines.front()) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
        QVERIFY((low - ifs::Vector<2>(3, 5)).norm() < 1e-9); // a square
        QVERIFY((high - ifs::Vector<2>(23, 25)).norm() < 1e-9);
        QVERIFY(std::abs(traced.target.size - 20) < 1e-9);
        const ifs::AffineMap<2> there = traced.place.map();
        Fractal moved = quarters();
        for (auto& map : system2(moved)->maps)
            map.map = *ifs::conjugate<2>(there, map.map);
        QVERIFY(std::abs(meanDistance(moved, traced) - meanDistance(quarters(), units)) < 1e-6);
        const auto refined = withMapsRefined(moved, traced, {});
        QVERIFY(refined && meanDistance(*refined, traced) < 0.5);
        const auto bound = shadesBound(moved, traced), ofUnits = shadesBound(quarters(), units);
        QVERIFY2(bound && ofUnits && std::abs(*bound - *ofUnits) < 1e-2,
                 qPrintable(QStringLiteral("%1 %2").arg(bound.value_or(-1)).arg(ofUnits.value_or(-1))));
        collage::Suggestion suggestion;
        suggestion.maps = {ifs::affineMap(0.5, 0.1, -0.1, 0.4, 0.2, -0.3)};
        suggestion.weights = {1};
        const Fractal suggested = withSuggestion(moved, suggestion, traced.place);
        const ifs::AffineMap<2>& map = system2(suggested)->maps.at(0).map;
        for (const ifs::Vector<2>& point : {ifs::Vector<2>(0.3, 0.2), ifs::Vector<2>(-0.4, 0.1)})
            QVERIFY((map(there(point)) - there(suggestion.maps[0](point))).norm() < 1e-9);
        // A point has no size.
        QCOMPARE(square(Box{{1, 1}, {1, 1}}).place.height, 1.0);
        const TracedPicture onLine = square(Box{{2, 1}, {6, 1}});
        QVERIFY(std::abs(onLine.target.size - 4) < 1e-9);
    }

    void allFitsCanBeStopped() {
        const TracedPicture traced = square();
        std::stop_source source;
        const auto token = source.get_token();
        QVERIFY(withCageFittedTo(quarters(), traced, 4, token));
        QVERIFY(withMapAdded(quarters(), traced, {0, 0}, {}, token));
        source.request_stop();
        QVERIFY(!withMapsRefined(quarters(), traced, {}, token));
        QVERIFY(!withAttractorRefined(quarters(), traced, {}, token));
        QVERIFY(!withWeightsFitted(quarters(), traced, token));
        QVERIFY(!withCageFittedTo(quarters(), traced, 4, token));
        QVERIFY(!withMapAdded(quarters(), traced, {0, 0}, {}, token));
    }
};

BARYCAGE_TEST(CollageEditsTest);
#include "collage_edits_test.moc"
