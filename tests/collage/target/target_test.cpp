// SPDX-License-Identifier: MIT
#include "collage/target/target.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QTest>

using namespace collage;

namespace {

GreyPicture picture(int width, int height, std::vector<std::uint8_t> grey,
                    std::vector<std::uint8_t> opacity = {}) {
    if (opacity.empty()) opacity.assign(grey.size(), 255);
    return {width, height, std::move(grey), std::move(opacity)};
}

using Cells = std::vector<std::uint8_t>;

} // namespace

class TargetTest : public QObject {
    Q_OBJECT

private slots:
    void otsuSeparatesTwoClasses() {
        QCOMPARE(otsuThreshold({10, 10, 12, 200, 210, 205}).value(), 105); // the middle of 12 … 199
        QVERIFY(!otsuThreshold({7, 7, 7}));
        QVERIFY(!otsuThreshold({}));
        QCOMPARE(otsuThreshold({0, 255}).value(), 127);
    }

    void whatIsDarkOrOpaqueIsTheShape() {
        const GreyPicture dark = picture(2, 2, {0, 250, 255, 20});
        QCOMPARE(targetMask(dark, {}, Polarity::Shape).cells, (Cells{1, 0, 0, 1}));
        QCOMPARE(targetMask(dark, {}, Polarity::Background).cells, (Cells{0, 1, 1, 0}));
        QCOMPARE(targetMask(dark, 19, Polarity::Shape).cells, (Cells{1, 0, 0, 0}));
        QCOMPARE(targetMask(dark, 20, Polarity::Shape).cells, (Cells{1, 0, 0, 1}));
        // A white drawing on nothing.
        const GreyPicture clear = picture(2, 2, {255, 255, 255, 255}, {0, 255, 130, 100});
        QCOMPARE(targetMask(clear, {}, Polarity::Shape).cells, (Cells{0, 1, 1, 0}));
        QCOMPARE(area(targetMask(picture(2, 1, {9, 9}), {}, Polarity::Shape)), 0U);
    }

    void croppingKeepsTheBox() {
        const GreyPicture whole = picture(3, 2, {0, 1, 2, 3, 4, 5});
        QCOMPARE(cropped(whole, {1, 0, 3, 2}).grey, (Cells{1, 2, 4, 5}));
        Mask mask = emptyMask(5, 4);
        QCOMPARE(boxOf(mask), PixelBox{});
        mask.cells[mask.index(1, 2)] = mask.cells[mask.index(3, 1)] = 1;
        QCOMPARE(boxOf(mask), (PixelBox{1, 1, 4, 3}));
    }

    // The height of the picture is 1 unit, y is up, its middle is the origin.
    void gridsLieInThePlaneOfThePicture() {
        Mask mask = emptyMask(20, 10);
        for (int y = 2; y < 6; ++y)
            for (int x = 4; x < 16; ++x)
                mask.cells[mask.index(x, y)] = 1;
        for (const int factor : {1, 2, 4}) {
            const Target found = target(mask, factor, 0.25);
            const auto plane = found.grid.fromGrid();
            QVERIFY(support::near<2>(plane(found.mean), ifs::Vector<2>(0, 0.1), 1e-12));
            QVERIFY(support::near(found.size, 1.2, 1e-12));
            QCOMPARE(int(found.cells.size()), 48 / (factor * factor));
            const auto map = ifs::affineMap(0.3, 0.2, -0.1, 0.4, 0.5, -0.6);
            const auto back = fromGrid(found.grid, inGrid(found.grid, map));
            QVERIFY((back.linear - map.linear).norm() < 1e-12);
            QVERIFY(support::near<2>(back.translation, map.translation, 1e-12));
        }
    }

    void thinLinesStayInCoarseGrids() {
        Mask mask = emptyMask(64, 64);
        for (int x = 0; x < 64; ++x)
            mask.cells[mask.index(x, 10)] = 1;
        QCOMPARE(target(mask, 8, 0).cells.size(), 8U);
        QCOMPARE(factorFor(mask, 8), 8);
        QCOMPARE(factorFor(mask, 64), 1);
        QCOMPARE(factorFor(mask, 63), 2);
    }
};

BARYCAGE_TEST(TargetTest);
#include "target_test.moc"
