// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/address_search.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>

using namespace ifs;
using namespace canonical;

namespace {

std::optional<AddressMatch> near(const SupportFunction<2>& attractor, const Vector<2>& x, double reach,
                                 double width, int maxNodes = 20'000) {
    const AddressQuery anywhere{x};
    return addressNear(attractor, {&anywhere, 1}, reach, width, maxNodes);
}

} // namespace

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
            const auto found = near(*attractor, point, 1e-3, 1e-3);
            QVERIFY(found);
            QVERIFY(found->address.size() >= 6 && found->address.size() < word.size());
            QVERIFY(std::equal(found->address.begin(), found->address.end(), word.begin()));
            QVERIFY(found->distance <= 2e-3);
        }
    }

    void knownAddressesAreFoundInSpace() {
        Maps3 maps = tetrahedron();
        for (AffineMap<3>& map : maps)
            map.linear *= 0.8; // apart from each other
        const auto attractor = SupportFunction<3>::of(maps);
        Random random(6);
        for (int n = 0; n < 50; ++n) {
            Word word;
            for (int k = 0; k < 30; ++k)
                word.push_back(int(random() % 4));
            const AddressQueryIn<3> anywhere{composed<3>(maps, word)({0.3, 0.3, 0.3})};
            const auto found = addressNear(*attractor, {&anywhere, 1}, 1e-3, 1e-3);
            QVERIFY(found);
            QVERIFY(found->address.size() >= 6 && found->address.size() < word.size());
            QVERIFY(std::equal(found->address.begin(), found->address.end(), word.begin()));
        }
    }

    // Of systems whose pieces are long and overlap, too. Deeper than this, a few addresses take more looks
    // than there are.
    void theAddressIsFoundFarInside() {
        const auto attractor = SupportFunction<2>::of(maple());
        Random random(11);
        for (double pixel = 1e-2; pixel > 3e-11; pixel /= 10)
            for (int n = 0; n < 5; ++n) {
                Word word;
                for (int k = 0; k < 200; ++k)
                    word.push_back(int(random() % 4));
                const Vector<2> point = composed<2>(maple(), word)(attractor->pointOfAttractor());
                const auto found = near(*attractor, point, 3 * pixel, pixel);
                QVERIFY2(found, qPrintable(QString::number(pixel)));
                const Vector<2> there = composed<2>(maple(), found->address)(attractor->pointOfAttractor());
                QVERIFY((there - point).norm() <= 4 * pixel);
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
            const auto found = near(*attractor, x, 2 * pixel, pixel);
            QVERIFY(found);
            const auto fixed = addressPoint<2>(maps, found->address, {0});
            QVERIFY((*fixed - x).norm() <= 3 * pixel);
        }
    }

    void farFromTheAttractorThereIsNone() {
        const auto attractor = SupportFunction<2>::of(Maps2{maple()});
        QVERIFY(!near(*attractor, {100, 100}, 1, 0.01));
        const auto holes = SupportFunction<2>::of(Maps2{sierpinskiRight()});
        QVERIFY(!near(*holes, {0.4, 0.4}, 0.01, 0.01)); // in the great hole
        QVERIFY(near(*holes, {0.4, 0.4}, 0.2, 0.01));
    }

    // Every point has so many addresses that not all can be looked at; one is found all the same.
    void thereIsAnAddressAmongManyMaps() {
        for (const int side : {10, 32, 100}) {
            Maps2 maps;
            for (int i = 0; i < side * side; ++i)
                maps.push_back({Matrix<2>::Identity() / 2, Vector<2>(i % side, i / side) / (2 * side)});
            const auto attractor = SupportFunction<2>::of(maps);
            QVERIFY(attractor);
            const double extent = (side - 1.0) / side; // a square, which has no holes
            Random random(6);
            for (int n = 0; n < 10; ++n) {
                const Vector<2> x =
                    extent * Vector<2>(double(random() % 1000) / 999, double(random() % 1000) / 999);
                const auto found = near(*attractor, x, 0.003, 0.001);
                QVERIFY(found);
                QVERIFY((composed<2>(maps, found->address)(attractor->pointOfAttractor()) - x).norm() <
                        0.004);
            }
            QVERIFY(!near(*attractor, {-0.01, 0.5}, 0.003, 0.001));
        }
    }

    // The search ends at its bound, and what it has then is no address when it is wider than was asked for.
    void withTooFewNodesThereIsNone() {
        const auto attractor = SupportFunction<2>::of(Maps2{sierpinskiRight()});
        QVERIFY(near(*attractor, {0, 0}, 0.01, 1e-6));
        QVERIFY(!near(*attractor, {0, 0}, 0.01, 1e-6, 20));
    }
};

BARYCAGE_TEST(AddressSearchTest);
#include "address_search_test.moc"
