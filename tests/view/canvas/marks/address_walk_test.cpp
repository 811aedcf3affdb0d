// SPDX-License-Identifier: MIT
#include "canvas/marks/address_walk.h"

#include "document/fractal/fractal_geometry.h"
#include "support/named_test.h"

#include <QtTest>

class AddressWalkTest : public QObject {
    Q_OBJECT

private slots:
    void everyStepIsInsideTheOneBefore() {
        const document::Fractal fractal = document::sierpinskiTriangle();
        const ifs::Word word{1, 2, 0, 0};
        const auto walk = view::addressWalk(fractal, word);
        QCOMPARE(walk.size(), word.size());
        const auto cage = document::effectiveCage(fractal).rest;
        ifs::AffineMap<2> map;
        double before = 1e9;
        for (std::size_t k = 0; k < walk.size(); ++k) {
            map = map * document::system2(fractal)->maps[std::size_t(word[k])].map;
            QCOMPARE(walk[k].size(), cage.size());
            for (std::size_t j = 0; j < cage.size(); ++j)
                QVERIFY((walk[k][j] - map(cage[j])).norm() < 1e-12);
            const double side = (walk[k][1] - walk[k][0]).norm();
            QVERIFY(side < 0.51 * before);
            before = side;
        }
    }

    void whatIsNoWordHasNoWalk() {
        QVERIFY(view::addressWalk({}, {0, 1}).empty());
        QCOMPARE(view::addressWalk(document::sierpinskiTriangle(), {0, 7, 1}).size(), std::size_t{1});
    }
};

BARYCAGE_TEST(AddressWalkTest, QApplication);
#include "address_walk_test.moc"
