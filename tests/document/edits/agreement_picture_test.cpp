// SPDX-License-Identifier: MIT
#include "collage/random_collages.h"
#include "document/edits/agreement_picture.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace document;

namespace {

// Dark on light.
collage::GreyPicture pictureOf(const collage::Mask& mask) {
    collage::GreyPicture picture{mask.width, mask.height, {}, {}};
    for (const std::uint8_t cell : mask.cells) {
        picture.grey.push_back(cell != 0 ? 20 : 240);
        picture.opacity.push_back(255);
    }
    return picture;
}

} // namespace

class AgreementPictureTest : public QObject {
    Q_OBJECT

private slots:
    // What is measured of large cells promises no more than is true of pixels.
    void liveBoundIsNeverViolated() {
        std::mt19937 random(21);
        int coarse = 0;
        double tightest = HUGE_VAL;
        for (int trial = 0; trial < 40; ++trial) {
            const auto collage = random_collages::contracting(random, 400);
            const auto traced = tracedPicture(pictureOf(collage.mask), {});
            QVERIFY(traced && traced->mask == collage.mask);
            if (!traced->coarse) continue;
            ++coarse;
            const auto live =
                measured(support::fractalOf(collage.maps), *traced, Compared::Collage, Detail::Live);
            QVERIFY(live && live->bound);
            const double widening = 1 / (1 - collage::contraction(collage.maps));
            const auto truth =
                random_collages::distanceToAttractor(traced->target, collage.maps, widening, 8);
            QVERIFY2(truth.least <= *live->bound,
                     qPrintable(QStringLiteral("%1: %2 > %3").arg(trial).arg(truth.least).arg(*live->bound)));
            if (truth.least > 20) tightest = std::min(tightest, *live->bound / truth.least);
        }
        QVERIFY2(coarse >= 10, qPrintable(QString::number(coarse)));
        QVERIFY2(tightest < 2, qPrintable(QString::number(tightest))); // it says something
    }
};

BARYCAGE_TEST(AgreementPictureTest);
#include "agreement_picture_test.moc"
