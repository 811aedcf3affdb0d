// SPDX-License-Identifier: MIT
#include "ifs/address_search.h"
#include "ifs/canonical_systems.h"

#include <QtTest>

#include <algorithm>

using namespace ifs;
using namespace canonical;

class AddressSearchTest : public QObject {
    Q_OBJECT

private slots:
    // Points of known address, in a system whose pieces do not overlap, have that address.
    void knownAddressesAreFound() {
        Maps2 maps = sierpinskiRight();
        for (AffineMap<2>& map : maps)
            map.linear *= 0.8; // apart from each other
        const auto attractor = SupportFunction<2>::of(maps);
        Random random(5);
        for (int n = 0; n < 100; ++n) {
            Word word;
            for (int k = 0; k < 30; ++k)
                word.push_back(int(random() % 3));
            const Vector<2> point = composed<2>(maps, word)({0.3, 0.3});
            const auto found = addressNear(*attractor, point, 1e-3, 1e-3);
            QVERIFY(found);
            QVERIFY(found->address.size() >= 6 && found->address.size() < word.size());
            QVERIFY(std::equal(found->address.begin(), found->address.end(), word.begin()));
            QVERIFY(found->distance <= 2e-3);
        }
    }

    // Where pieces overlap any address will do that leads there.
    void theAddressLeadsToThePoint_data() {
        QTest::addColumn<Maps2>("maps");
        QTest::newRow("maple") << maple();
        QTest::newRow("fern") << fern();
        QTest::newRow("levy") << levy();
        QTest::newRow("eventually contractive")
            << Maps2{affineMap(.5, 2, 0, .5, 0, 0), affineMap(.5, 0, .1, .3, 1, 0)};
    }
    void theAddressLeadsToThePoint() {
        QFETCH(Maps2, maps);
        const auto attractor = SupportFunction<2>::of(maps);
        QVERIFY(attractor);
        const double pixel = attractor->radius() / 500;
        Random random(8);
        Vector<2> x = attractor->pointOfAttractor();
        for (int n = 0; n < 300; ++n) {
            x = maps[random() % maps.size()](x);
            const auto found = addressNear(*attractor, x, 2 * pixel, pixel);
            QVERIFY(found);
            const auto fixed = addressPoint<2>(maps, found->address, {0});
            QVERIFY((*fixed - x).norm() <= 3 * pixel);
        }
    }

    void farFromTheAttractorThereIsNone() {
        const auto attractor = SupportFunction<2>::of(Maps2{maple()});
        QVERIFY(!addressNear(*attractor, {100, 100}, 1, 0.01));
        const auto holes = SupportFunction<2>::of(Maps2{sierpinskiRight()});
        QVERIFY(!addressNear(*holes, {0.4, 0.4}, 0.01, 0.01)); // in the great hole
        QVERIFY(addressNear(*holes, {0.4, 0.4}, 0.2, 0.01));
    }

    // The search ends at its bound, and what it has then is no address when it is wider than was asked for.
    void withTooFewNodesThereIsNone() {
        const auto attractor = SupportFunction<2>::of(Maps2{sierpinskiRight()});
        QVERIFY(addressNear(*attractor, {0, 0}, 0.01, 1e-6));
        QVERIFY(!addressNear(*attractor, {0, 0}, 0.01, 1e-6, {}, 20));
    }
};

QTEST_APPLESS_MAIN(AddressSearchTest)
#include "address_search_test.moc"
