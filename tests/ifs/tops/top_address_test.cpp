// SPDX-License-Identifier: MIT
#include "ifs/tops/fractal_transformation.h"

#include "ifs/canonical_systems.h"
#include "ifs/tops/top_systems.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QTest>

#include <numbers>

using canonical::uniform;
using ifs::Vector;
using support::near;
using namespace tops;

// Top addresses and T_FG at points, against closed forms.
class TopAddressTest : public QObject {
    Q_OBJECT

private slots:
    void homeomorphismOfTheInterval();
    void orderDecidesAtAJump();
    void addressInAnOverlap();
    void overlapAndItsReverse();
    void squares();
    void triangles();
    void commutesWithTheMaps_data();
    void commutesWithTheMaps();
    void modulusOfContinuity();
    void boundariesAndNeighboursOfBoundaries();
    void equalSystemsGiveTheIdentity_data();
    void equalSystemsGiveTheIdentity();
    void conjugateSystemsGiveTheirConjugacy();
    void backAndForth();
    void addressesAreThoseOfTheirPoints_data();
    void addressesAreThoseOfTheirPoints();
    void offTheAttractor();
    void degenerateSystems();
};

namespace {

ifs::FractalTransformation transformation(const Maps& from, const Maps& to) {
    return {attractorOf(from), to};
}

Vector<2> imageOf(const ifs::FractalTransformation& t, const Vector<2>& x) {
    return t.at(x).image.value_or(Vector<2>::Constant(canonical::quietNaN));
}

double onTheLine(const ifs::FractalTransformation& t, double x) {
    return imageOf(t, {x, 0}).x();
}

QByteArray text(const ifs::Word& word) {
    QByteArray digits;
    for (const int symbol : word)
        digits += QByteArray::number(symbol + 1);
    return digits;
}

QByteArray addressOf(const Maps& maps, const Vector<2>& x, std::size_t count) {
    const auto answer = ifs::TopSearch(attractorOf(maps)).at(x);
    return answer.top ? text(symbols(*answer.top, count)) : QByteArray("none");
}

} // namespace

void TopAddressTest::homeomorphismOfTheInterval() {
    const auto t = transformation(interval(0.5), interval(1.0 / 3));
    const double expected[][2] = {{0.5, 1.0 / 3},     {0.25, 1.0 / 9}, {0.75, 5.0 / 9}, {1.0 / 3, 1.0 / 7},
                                  {2.0 / 3, 3.0 / 7}, {0, 0},          {1, 1}};
    for (const auto& [x, image] : expected)
        QVERIFY2(near(onTheLine(t, x), image, 1e-14), qPrintable(QString::number(x)));
    QVERIFY(near(onTheLine(transformation(interval(0.5), interval(0.3)), 1.0 / 3), 9.0 / 79, 1e-14));
    canonical::Random random(1);
    double before = 0;
    for (int k = 1; k < 200; ++k) { // increasing, and T(x/2) = T(x)/3
        const double x = k / 200.0 + uniform(random, 0, 0.004);
        const double image = onTheLine(t, x);
        QVERIFY(image > before);
        QVERIFY(near(onTheLine(t, x / 2), image / 3, 1e-9));
        QVERIFY(near(image, hFunction(1.0 / 3, x), 1e-9));
        before = image;
    }
}

void TopAddressTest::orderDecidesAtAJump() {
    QVERIFY(near(onTheLine(transformation(interval(0.5), cantor()), 0.5), 1.0 / 3, 1e-14));
    const auto reversedOrder = transformation(reversed(interval(0.5)), reversed(cantor()));
    QVERIFY(near(onTheLine(reversedOrder, 0.5), 2.0 / 3, 1e-14));
    QCOMPARE(addressOf(interval(0.5), {0.5, 0}, 8), QByteArray("12222222"));
    QCOMPARE(addressOf(reversed(interval(0.5)), {0.5, 0}, 8), QByteArray("12222222"));
}

void TopAddressTest::addressInAnOverlap() {
    QCOMPARE(addressOf(overlappingInterval(), {0.5, 0}, 20), QByteArray("12122222122122121222"));
    // The masked rule: the upper map wherever x ≤ 2/3.
    canonical::Random random(2);
    for (int k = 0; k < 100; ++k) {
        const double x = uniform(random, 0, 1);
        QByteArray expected;
        double y = x;
        for (int n = 0; n < 30; ++n) {
            expected += y <= 2.0 / 3 ? '1' : '2';
            y = y <= 2.0 / 3 ? 1.5 * y : 1.5 * y - 0.5;
        }
        QCOMPARE(addressOf(overlappingInterval(), {x, 0}, 30), expected);
    }
}

// They see the same piece exactly where only one piece is.
void TopAddressTest::overlapAndItsReverse() {
    const ifs::TopSearch upper(attractorOf(overlappingInterval()));
    const ifs::TopSearch lower(attractorOf(reversed(overlappingInterval())));
    for (int k = 0; k <= 300; ++k) {
        const double x = k / 300.0;
        const int first = upper.at({x, 0}).top->word.front(), other = 1 - lower.at({x, 0}).top->word.front();
        QCOMPARE(first != other, k >= 100 && k <= 200);
    }
}

void TopAddressTest::squares() {
    const auto t = transformation(square(0.5, 0.5), square(0.3, 1.0 / 3));
    QVERIFY(near(imageOf(t, {1.0 / 3, 1.0 / 3}), Vector<2>(9.0 / 79, 1.0 / 7), 1e-13));
    QVERIFY(near(imageOf(t, {0.25, 0.75}), Vector<2>(0.09, 5.0 / 9), 1e-14));
    QVERIFY(near(imageOf(t, {0.5, 0.25}), Vector<2>(0.3, 1.0 / 9), 1e-14));
    canonical::Random random(3);
    for (int k = 0; k < 100; ++k) {
        const Vector<2> x(uniform(random, 0, 1), uniform(random, 0, 1));
        const Vector<2> expected(hFunction(0.3, x.x()), hFunction(1.0 / 3, x.y()));
        QVERIFY(near(imageOf(t, x), expected, 1e-8));
    }
}

void TopAddressTest::triangles() {
    const auto t = transformation(triangle(.5, .5, .5), triangle(.65, .3, .4));
    const Vector<2> expected[][2] = {{{.5, 0}, {.65, 0}},
                                     {{.25, 0}, {.2275, 0}},
                                     {{.5, .25}, {.6825, .195}},
                                     {{.375, .375}, {.557375, .32175}},
                                     {{1.0 / 3, 1.0 / 3}, {52.0 / 115, 39.0 / 115}},
                                     {{0, 0}, {0, 0}},
                                     {{1, 0}, {1, 0}},
                                     {{0, 1}, {0, 1}}};
    for (const auto& [x, image] : expected)
        QVERIFY2(near(imageOf(t, x), image, 1e-12), qPrintable(QString::number(x.x())));
    QVERIFY(addressOf(triangle(.5, .5, .5), {0, 0}, 9) == "312312312");
    QVERIFY(addressOf(triangle(.5, .5, .5), {1, 0}, 9) == "123123123");
    QVERIFY(addressOf(triangle(.5, .5, .5), {0, 1}, 9) == "231231231");
}

void TopAddressTest::commutesWithTheMaps_data() {
    QTest::addColumn<Maps>("from");
    QTest::addColumn<Maps>("to");
    QTest::newRow("intervals") << interval(.5) << interval(1.0 / 3);
    QTest::newRow("squares") << square(.5, .5) << square(.3, 1.0 / 3);
    QTest::newRow("triangles") << triangle(.5, .5, .5) << triangle(.65, .3, .4);
}

// T∘f_i = g_i∘T for all i where T is continuous, also where another piece is on top.
void TopAddressTest::commutesWithTheMaps() {
    QFETCH(Maps, from);
    QFETCH(Maps, to);
    const auto t = transformation(from, to);
    int compared = 0;
    for (int k = 0; k <= 8; ++k)
        for (int l = 0; l <= 8; ++l) {
            const Vector<2> x(k / 8.0, l / 8.0);
            const auto image = t.at(x).image;
            if (!image) continue; // not in the attractor
            for (std::size_t i = 0; i < from.size(); ++i) {
                QVERIFY(near(imageOf(t, from[i](x)), to[i](*image), 1e-12));
                ++compared;
            }
        }
    QVERIFY(compared >= 2 * 9);
}

// Of 40 000 points, the largest difference of images within a distance: .152, .104, .062 and .037, up to
// what chance does.
void TopAddressTest::modulusOfContinuity() {
    const Maps from = triangle(.5, .5, .5);
    const auto t = transformation(from, triangle(.65, .3, .4));
    canonical::Random random(9);
    std::vector<Vector<2>> points = canonical::orbit<2>(from, 40'000, random), images;
    std::ranges::sort(points, {}, [](const Vector<2>& x) { return x.x(); });
    for (const Vector<2>& x : points)
        images.push_back(imageOf(t, x));
    double before = canonical::infinity;
    for (const auto& [within, expected] : {std::pair{.02, .152}, {.01, .104}, {.005, .062}, {.0025, .037}}) {
        double largest = 0;
        for (std::size_t k = 0; k < points.size(); ++k)
            for (std::size_t l = k + 1; l < points.size() && points[l].x() - points[k].x() <= within; ++l)
                if ((points[k] - points[l]).norm() <= within)
                    largest = std::max(largest, (images[k] - images[l]).norm());
        QVERIFY2(largest > .75 * expected && largest < 1.35 * expected, qPrintable(QString::number(largest)));
        QVERIFY(largest < before);
        before = largest;
    }
}

// Both sides of a jump, as near as doubles go without the rounding of the maps.
void TopAddressTest::boundariesAndNeighboursOfBoundaries() {
    const auto t = transformation(interval(0.5), cantor());
    QVERIFY(near(onTheLine(t, 0.5 - 1e-12), 1.0 / 3, 1e-6));
    QVERIFY(near(onTheLine(t, 0.5 + 1e-12), 2.0 / 3, 1e-6));
    QVERIFY(near(onTheLine(t, 0.25), 1.0 / 9, 1e-14));
    QVERIFY(near(onTheLine(t, 0.75), 7.0 / 9, 1e-14));
    QVERIFY(near(onTheLine(t, 0.625), 19.0 / 27, 1e-14)); // 2112222…: 2/3 + 1/27
}

void TopAddressTest::equalSystemsGiveTheIdentity_data() {
    QTest::addColumn<Maps>("maps");
    QTest::newRow("fern") << canonical::fern();
    QTest::newRow("maple") << canonical::maple();
    QTest::newRow("Sierpiński") << canonical::sierpinskiEquilateral();
    QTest::newRow("Lévy") << canonical::levy();
    QTest::newRow("stretches before it contracts") << canonical::eventual();
    QTest::newRow("triangle") << triangle(.65, .3, .4);
}

void TopAddressTest::equalSystemsGiveTheIdentity() {
    QFETCH(Maps, maps);
    const auto t = transformation(maps, maps);
    canonical::Random random(4);
    for (const Vector<2>& x : canonical::orbit<2>(maps, 60, random)) {
        const auto answer = t.at(x);
        QVERIFY(answer.image);
        QVERIFY(near(*answer.image, x, 1e-9));
    }
}

void TopAddressTest::conjugateSystemsGiveTheirConjugacy() {
    canonical::Random random(5);
    for (int k = 0; k < 8; ++k) {
        const ifs::AffineMap<2> change{canonical::randomWellConditioned<2>(random, 4),
                                       canonical::randomVector<2>(random, 3)};
        const Maps maps = k % 2 == 0 ? canonical::fern() : canonical::sierpinskiRight();
        Maps other;
        for (const auto& map : maps)
            other.push_back(*ifs::conjugate<2>(change, map));
        const auto t = transformation(maps, other);
        for (const Vector<2>& x : canonical::orbit<2>(maps, 40, random))
            QVERIFY(near(imageOf(t, x), change(x), 1e-7));
    }
}

void TopAddressTest::backAndForth() {
    const Maps f = triangle(.5, .5, .5), g = triangle(.65, .3, .4);
    const auto there = transformation(f, g), back = transformation(g, f);
    canonical::Random random(6);
    for (int k = 0; k < 100; ++k) {
        Vector<2> x(uniform(random, 0, 1), uniform(random, 0, 1));
        if (x.sum() > 1) x = Vector<2>(1, 1) - x;
        QVERIFY(near(imageOf(back, imageOf(there, x)), x, 1e-4));
    }
}

void TopAddressTest::addressesAreThoseOfTheirPoints_data() {
    equalSystemsGiveTheIdentity_data();
}

// Reported points lie on the attractor where their addresses say, and no piece with a greater address holds
// them: no word that comes first in the order, to a length, has a ball around it that reaches the point.
void TopAddressTest::addressesAreThoseOfTheirPoints() {
    QFETCH(Maps, maps);
    const auto support = attractorOf(maps);
    const ifs::TopSearch search(support);
    canonical::Random random(7);
    for (const Vector<2>& x : canonical::orbit<2>(maps, 40, random)) {
        const auto answer = search.at(x);
        QVERIFY(answer.top && !answer.isCutShort);
        const auto& top = *answer.top;
        QVERIFY(near(top.point, x, 64 * search.tolerance()));
        QVERIFY(near(*pointOf(top, maps), top.point, 1e-12));
        // At the depth of 40 maps or of what doubles carry, whichever comes first.
        const double size = ifs::spectralNorm<2>(ifs::composed<2>(maps, top.word).linear) * support.radius();
        QVERIFY(top.word.size() >= 40 || size <= search.tolerance());
    }
}

void TopAddressTest::offTheAttractor() {
    const auto t = transformation(interval(0.5), cantor());
    QVERIFY(!t.at({0.5, 1e-8}).top);
    QVERIFY(!t.at({-1e-8, 0}).image);
    QVERIFY(!t.at({canonical::quietNaN, 0}).image);
    QVERIFY(!t.at({canonical::infinity, 0}).image);
    QVERIFY(near(imageOf(t, {0.25, 1e-10}).x(), 1.0 / 9, 1e-6)); // the nearest point
    QVERIFY(near(imageOf(t, {-5e-10, 0}).x(), 0, 1e-6));
    const auto holes = transformation(cantor(), interval(0.5));
    QVERIFY(!holes.at({0.5, 0}).image);                    // between the pieces
    QVERIFY(near(onTheLine(holes, 0.25), 1.0 / 3, 1e-12)); // 0.020202… in base 3
}

void TopAddressTest::degenerateSystems() {
    const auto point = transformation({onLine(0.5, 1)}, {onLine(0.25, 3)});
    QVERIFY(near(imageOf(point, {2, 0}), Vector<2>(4, 0), 1e-12));
    // Maps without an inverse, and one that is a point.
    const Maps flat{ifs::affineMap(.5, 0, 0, 0, 0, 0), ifs::affineMap(0, 0, 0, 0, 1, 0)};
    const auto t = transformation(flat, interval(0.5));
    QVERIFY(near(imageOf(t, {0.5, 0}).x(), 0.25, 1e-12)); // 12111…
    // Hundreds of maps on each other.
    const Maps many(300, onLine(0.9, 0.1));
    QVERIFY(near(imageOf(transformation(many, many), {1, 0}), Vector<2>(1, 0), 1e-9));
}

BARYCAGE_TEST(TopAddressTest);
#include "top_address_test.moc"
