// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/extreme_points.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

std::vector<std::optional<PeriodicPoint>> extremePoints(const Maps2& maps, double tolerance = 0) {
    const auto support = *SupportFunction<2>::of(maps);
    return periodicExtremePoints(support, convexHull(support, tolerance));
}
// Written with digits from 1 on: "3(322)".
Word wordOf(const char* digits) {
    Word word;
    for (; *digits != 0; ++digits)
        word.push_back(*digits - '1');
    return word;
}
// The first symbols of the infinite address.
Word expanded(const Word& prefix, const Word& period) {
    constexpr std::size_t symbols = 120;
    Word word = prefix;
    while (word.size() < symbols)
        word.push_back(period[(word.size() - prefix.size()) % period.size()]);
    word.resize(symbols);
    return word;
}
bool has(const std::vector<std::optional<PeriodicPoint>>& found, const Vector<2>& point, const char* prefix,
         const char* period, double tolerance) {
    return std::ranges::any_of(found, [&](const auto& p) {
        return p && (p->point - point).norm() <= tolerance &&
               expanded(p->prefix, p->period) == expanded(wordOf(prefix), wordOf(period));
    });
}

} // namespace

class ExtremePointsTest : public QObject {
    Q_OBJECT

private slots:
    void polygons() {
        const auto octagon = extremePoints(levy());
        QCOMPARE(octagon.size(), std::size_t(8));
        QVERIFY(has(octagon, {1.5, .5}, "22", "12", 1e-15));
        QVERIFY(has(octagon, {1, 1}, "2", "12", 1e-15));
        QVERIFY(has(octagon, {0, 1}, "", "12", 1e-15));
        QVERIFY(has(octagon, {-.5, .5}, "1", "12", 1e-15));
        QVERIFY(has(octagon, {-.5, 0}, "11", "12", 1e-15));
        QVERIFY(has(octagon, {-.25, -.25}, "111", "12", 1e-15));
        QVERIFY(has(octagon, {1.25, -.25}, "2222", "12", 1e-15));
        QVERIFY(has(octagon, {1.5, 0}, "222", "12", 1e-15));
        const auto decagon = extremePoints(heighway());
        QCOMPARE(decagon.size(), std::size_t(10));
        QVERIFY(has(decagon, {-1. / 3, 1. / 3}, "", "1122", 1e-15));
        const auto gasket = extremePoints(sierpinskiEquilateral());
        QCOMPARE(gasket.size(), std::size_t(3));
        QVERIFY(has(gasket, {.5, std::sqrt(3) / 2}, "", "3", 1e-15));
        for (const auto& corners : {octagon, decagon, gasket, extremePoints(twin()), extremePoints(koch())})
            for (const auto& corner : corners)
                QVERIFY(corner);
        // The top of Koch's curve has two addresses; either will do.
        const auto curve = extremePoints(koch());
        QVERIFY(has(curve, {.5, std::sqrt(3) / 6}, "2", "4", 1e-15) ||
                has(curve, {.5, std::sqrt(3) / 6}, "3", "1", 1e-15));
    }

    void mapleHasCountablyMany() {
        const auto found = extremePoints(maple(), 1e-12);
        struct Listed {
            Vector<2> point;
            const char *prefix, *period;
        };
        const Listed listed[] = {
            {{3.3442144495405580, 0.3195607551473931}, "3", "323223232"},
            {{3.3326173744955513, 0.5898057032257208}, "3", "322323232"},
            {{3.2384057151321740, 1.7121112646978691}, "3", "232323232"},
            {{3.2371604277129770, 1.7171480038262361}, "", "323232322"},
            {{3.2287032507195057, 1.7405960934671075}, "", "323232232"},
            {{3.1840860069842702, 1.8433053275889045}, "", "323223232"},
            {{2.9737160045674325, 2.2748343845748970}, "", "322323232"},
            {{2.0446678609049159, 4.0323158811861332}, "2", "323232322"},
            {{0.1794871794871795, 5.0724637681159420}, "", "2"},
            {{-0.9992845271945276, 4.8500810965789935}, "2", "24"},
            {{-1.7529254544172583, 4.3551003115451404}, "", "24"},
            {{-2.9884023842905874, 2.7583881017585173}, "", "42"},
            {{-3.3000939564735311, 1.6665529554982757}, "4", "42"},
            {{-3.1720260187925426, 1.0052546220432694}, "44", "42"},
            {{-0.1149408364417088, -3.1730384210581172}, "12", "223232323"},
            {{-0.1148640517020626, -3.1730509611301708}, "122", "232323223"},
            {{-0.1144589610380519, -3.1727105668280289}, "122", "232322323"},
            {{2.9816439788683361, -0.4971027820721325}, "333", "232323232"},
            {{2.9828767243515613, -0.4959583612460169}, "33", "323232322"},
            {{2.9877232804455653, -0.4897289221907292}, "33", "323232232"},
            {{3.0064120111941067, -0.4598751723914187}, "33", "323223232"},
            {{3.0772449473575674, -0.3266784748003194}, "33", "322323232"},
            {{3.3414759815982951, 0.2402916925153250}, "33", "232323232"},
            {{3.3421271991230435, 0.2430829135227002}, "3", "323232322"},
            {{3.3434299800731399, 0.2568751496483599}, "3", "323232232"},
        };
        for (const auto& [point, prefix, period] : listed)
            QVERIFY2(has(found, point, prefix, period, 1e-14),
                     qPrintable(QStringLiteral("%1(%2)").arg(QLatin1String(prefix), QLatin1String(period))));
    }

    // Every proved point is the point of its address, and no point of the attractor is beyond it.
    void whatIsProvedIsExtreme() {
        Random random(7);
        int proved = 0;
        for (int n = 0; n < 12; ++n) {
            const auto maps = randomContractions<2>(random, 2 + int(random() % 3));
            const auto support = *SupportFunction<2>::of(maps);
            const auto hull = convexHull(support, 1e-6 * support.radius());
            const auto found = periodicExtremePoints(support, hull);
            QCOMPARE(found.size(), hull.vertices.size());
            for (std::size_t k = 0; k < found.size(); ++k) {
                if (!found[k]) continue;
                ++proved;
                const auto& [prefix, period, point] = *found[k];
                QVERIFY((*addressPoint<2>(maps, prefix, period) - point).norm() <= 1e-12 * support.radius());
                QVERIFY((point - hull.vertices[k]).norm() <= 1e-4 * support.radius());
                QVERIFY(prefix.empty() || prefix.back() != period.back());
            }
        }
        QVERIFY(proved > 5);
    }

    // The topmost point agrees with (21)(21)… for 45 symbols and then leaves it: turns by an irrational angle
    // have no periodic extreme points.
    void whatOnlyLooksPeriodicIsNotTaken() {
        const auto support = *SupportFunction<2>::of(flower());
        const auto found = periodicExtremePoints(support, convexHull(support, 1e-8 * support.radius()));
        for (const auto& point : found)
            QVERIFY(!point);
    }

    void pointsAndSegments() {
        const auto point = extremePoints({affineMap(.5, 0, 0, .5, 1, 2)});
        QVERIFY(has(point, {2, 4}, "", "1", 1e-15));
        const auto segment = extremePoints({affineMap(.5, 0, 0, .5, 0, 0), affineMap(.5, 0, 0, .5, 1, 1)});
        QVERIFY(has(segment, {0, 0}, "", "1", 1e-15) && has(segment, {2, 2}, "", "2", 1e-15));
    }
};

BARYCAGE_TEST(ExtremePointsTest);
#include "extreme_points_test.moc"
