// SPDX-License-Identifier: MIT
#include "ifs/tops/tear.h"

#include "ifs/canonical_systems.h"
#include "ifs/tops/fractal_transformation.h"
#include "ifs/tops/top_systems.h"
#include "support/named_test.h"

#include <QTest>

using namespace tops;
using ifs::Homeomorphism;
using ifs::Vector;

// How far a fractal transformation tears, and whether it is proved to be a homeomorphism.
class TearTest : public QObject {
    Q_OBJECT

private slots:
    void jumpsAreSeen();
    void continuousOnesTearLessAndLess_data();
    void continuousOnesTearLessAndLess();
    void separatedPiecesDoNotTear();
    void boundsTheJumps();
    void agreesWithAllPairs();
    void limitsItsWork();
    void homeomorphisms_data();
    void homeomorphisms();
};

void TearTest::jumpsAreSeen() {
    for (const double epsilon : {0.1, 0.01, 0.001, 1e-6}) {
        const auto torn = ifs::tear(attractorOf(interval(0.5)), attractorOf(cantor()), epsilon);
        QVERIFY(torn.size >= 1.0 / 3 - epsilon);
        QVERIFY(torn.size <= 1.0 / 3 + 4 * std::sqrt(epsilon)); // of pieces of size ε^(log 3 / log 2)
        QVERIFY(!torn.isCutShort);
        QVERIFY(torn.place);
        for (const Vector<2>& x : *torn.place)
            QVERIFY((x - Vector<2>(0.5, 0)).norm() <= 3 * epsilon);
    }
}

void TearTest::continuousOnesTearLessAndLess_data() {
    QTest::addColumn<Maps>("from");
    QTest::addColumn<Maps>("to");
    QTest::newRow("intervals") << interval(0.5) << interval(1.0 / 3);
    QTest::newRow("triangles") << triangle(.5, .5, .5) << triangle(.65, .3, .4);
    QTest::newRow("squares") << square(.5, .5) << square(.3, .4);
    QTest::newRow("the same") << canonical::sierpinskiRight() << canonical::sierpinskiRight();
}

void TearTest::continuousOnesTearLessAndLess() {
    QFETCH(Maps, from);
    QFETCH(Maps, to);
    const auto f = attractorOf(from), g = attractorOf(to);
    double before = canonical::infinity;
    for (double epsilon = 0.25; epsilon > 0.002; epsilon /= 4) {
        const auto torn = ifs::tear(f, g, epsilon);
        QVERIFY(!torn.isCutShort);
        QVERIFY(torn.size < 0.9 * before);
        before = torn.size;
    }
    QVERIFY2(before < 0.25, qPrintable(QString::number(before)));
}

void TearTest::separatedPiecesDoNotTear() {
    const auto torn = ifs::tear(attractorOf(cantor()), attractorOf(interval(0.5)), 0.1);
    QCOMPARE(torn.size, 0.0);
    QVERIFY(!torn.place);
}

// Points of different first symbols within ε of each other have images no farther apart than the tear.
void TearTest::boundsTheJumps() {
    const Maps from = triangle(.5, .5, .5), to = triangle(.65, .3, .4);
    const ifs::FractalTransformation t(attractorOf(from), to);
    const double epsilon = 0.02;
    const double bound = ifs::tear(attractorOf(from), attractorOf(to), epsilon).size;
    canonical::Random random(8);
    int compared = 0;
    double largest = 0;
    for (int k = 0; k < 2000; ++k) {
        // About the edge c–a, between the first piece and the last.
        const Vector<2> x = Vector<2>(.5, canonical::uniform(random, 0, .5)) +
                            canonical::randomVector<2>(random, epsilon / 4);
        const Vector<2> y = x + canonical::randomVector<2>(random, epsilon / 2);
        const auto a = t.at(x), b = t.at(y);
        if (!a.top || !b.top || a.top->word.front() == b.top->word.front()) continue;
        ++compared;
        largest = std::max(largest, (*a.image - *b.image).norm());
    }
    QVERIFY(compared > 20);
    QVERIFY(largest > 0 && largest <= bound);
}

// Against looking at every pair of words, of systems with words of one length.
void TearTest::agreesWithAllPairs() {
    const Maps from = interval(0.5), to = cantor();
    constexpr int length = 5;
    const double epsilon = 1.0 / 32;
    double expected = 0;
    for (int a = 0; a < 16; ++a)
        for (int b = 16; b < 32; ++b) {
            if (b - a > 2) continue; // [a, a + 1]/32 and [b, b + 1]/32
            const auto pieceOf = [&](int word) {
                ifs::AffineMap<2> map;
                for (int k = length - 1; k >= 0; --k)
                    map = map * to[std::size_t(word >> k & 1)];
                return map;
            };
            const double low = pieceOf(a)({0, 0}).x(), high = pieceOf(b)({1, 0}).x();
            expected = std::max(expected, high - low);
        }
    const auto torn = ifs::tear(attractorOf(from), attractorOf(to), epsilon * (1 + 1e-8));
    QVERIFY(std::abs(torn.size - expected) < 1e-7);
}

void TearTest::limitsItsWork() {
    const Maps fern = canonical::fern();
    const auto torn = ifs::tear(attractorOf(fern), attractorOf(fern), 1e-9, 1000);
    QVERIFY(torn.isCutShort);
    const auto finer = ifs::tear(attractorOf(fern), attractorOf(fern), 1e-9, 20000);
    QVERIFY(finer.size > 0 && finer.size <= torn.size); // bounds both
    const auto nothing =
        ifs::tear(attractorOf(fern), attractorOf(fern), 1e-9, 10); // fewer than the first pairs
    QVERIFY(nothing.isCutShort && !nothing.place);
    for (const auto& bound : {torn, finer, nothing})
        QVERIFY(bound.size <= bound.whole &&
                bound.whole >= 0.999 * (attractorOf(fern)({0, 1}).value + attractorOf(fern)({0, -1}).value));
}

void TearTest::homeomorphisms_data() {
    QTest::addColumn<Maps>("from");
    QTest::addColumn<Maps>("to");
    QTest::addColumn<int>("expected");
    const auto row = [](const char* name, const Maps& from, const Maps& to, Homeomorphism expected) {
        QTest::newRow(name) << from << to << int(expected);
    };
    const Maps dust = canonical::halves({{0, 0}, {1, 0}, {0, 1}});
    Maps thin = dust, thinner = dust;
    for (auto& map : thin)
        map.linear *= 0.5;
    for (auto& map : thinner)
        map.linear *= 0.75;
    row("dust and dust", thin, thinner, Homeomorphism::Proved);
    row("itself", canonical::fern(), canonical::fern(), Homeomorphism::Proved);
    row("interval and dust", interval(0.5), cantor(), Homeomorphism::Refuted);
    row("dust and interval", cantor(), interval(0.5), Homeomorphism::Refuted);
    row("gasket and dust", canonical::sierpinskiRight(), thin, Homeomorphism::Refuted);
    row("triangles that rounding has moved", triangle(.5, .5, .5), triangle(.65, .3, .4),
        Homeomorphism::Unknown);
    row("fern and maple", canonical::fern(), canonical::maple(), Homeomorphism::Unknown);
    // Pieces of both meet or overlap, but only the square is connected.
    const Maps scattered{ifs::affineMap(.45, 0, 0, .45, 0, 0), ifs::affineMap(.65, 0, 0, .65, .3, 0),
                         ifs::affineMap(.45, 0, 0, .45, 0, .5), ifs::affineMap(.1, 0, 0, .1, 30, 0)};
    row("square and scattered pieces", canonical::square(), scattered, Homeomorphism::Refuted);
}

void TearTest::homeomorphisms() {
    QFETCH(Maps, from);
    QFETCH(Maps, to);
    QFETCH(int, expected);
    QCOMPARE(int(ifs::homeomorphism(attractorOf(from), attractorOf(to))), expected);
    QCOMPARE(int(ifs::homeomorphism(attractorOf(to), attractorOf(from))), expected);
}

BARYCAGE_TEST(TearTest);
#include "tear_test.moc"
