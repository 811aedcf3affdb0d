// SPDX-License-Identifier: MIT
#include "collage/measure/agreement.h"
#include "document/edits/collage_edits.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>

using namespace document;

namespace {

constexpr int side = 512, edge = 56; // of the picture, and of the white around a black square

TracedPicture square() {
    collage::GreyPicture picture{side, side, {}, {}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const bool isInside = std::min(x, y) >= edge && std::max(x, y) < side - edge;
            picture.grey.push_back(isInside ? 0 : 255);
            picture.opacity.push_back(255);
        }
    return *tracedPicture(picture, {});
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
