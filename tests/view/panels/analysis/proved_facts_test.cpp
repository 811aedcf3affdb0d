// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "view/panels/analysis/facts_support.h"
#include "view/panels/maps_support.h"

#include <QApplication>
#include <QtTest>

#include <cmath>

using namespace facts_support;
using namespace maps_support;

class ProvedFactsTest : public QObject {
    Q_OBJECT

private slots:
    void saysWhatIsProvedOfTheSierpinskiTriangle() {
        const auto facts = factsOf(document::sierpinskiTriangle());
        QCOMPARE(valueOf(facts, QStringLiteral("Attractor")), QStringLiteral("hyperbolic, s = 0.5"));
        QCOMPARE(valueOf(facts, QStringLiteral("Separation")), QStringLiteral("unknown"));
        QCOMPARE(valueOf(facts, QStringLiteral("Open set condition")),
                 QStringLiteral("holds")); // three triangles that touch, rounded or not
        QCOMPARE(valueOf(facts, QStringLiteral("Hausdorff dimension")), QStringLiteral("1.585"));
    }

    void saysUnknownOnlyWhereItIs() {
        const double third = 1.0 / 3;
        const double half = third / 2, high = std::sqrt(3.0) / 6;
        const auto koch = factsOf(fractalOf({{third, 0, 0, third, 0, 0, 1},
                                             {half, -high, high, half, third, 0, 1},
                                             {half, high, -high, half, .5, high, 1},
                                             {third, 0, 0, third, 2 * third, 0, 1}}));
        QVERIFY(valueOf(koch, QStringLiteral("Similarity dimension"))
                    .endsWith(QStringLiteral("(the open set condition holds, within rounding error)")));
        const auto digits = factsOf(fractalOf({{third, 0, 0, third, 0, 0, 1},
                                               {third, 0, 0, third, third, 0, 1},
                                               {third, 0, 0, third, 1, 0, 1}}));
        QCOMPARE(valueOf(digits, QStringLiteral("Hausdorff dimension")),
                 QStringLiteral("0.876 (finite type) (within rounding error)"));
        QCOMPARE(valueOf(digits, QStringLiteral("Open set condition")),
                 QStringLiteral("fails")); // 03 = 10, as stored
        const auto two = factsOf(
            fractalOf({{.5, 0, 0, .5, 0, 0, 1}, {.5, 0, 0, .5, .5, 0, 1}, {.25, 0, 0, .25, 0, .5, 1}}));
        QCOMPARE(valueOf(two, QStringLiteral("Open set condition")), QStringLiteral("holds"));
        const auto meeting = factsOf(
            fractalOf({{.6, 0, 0, .6, 0, 0, 1}, {.6, 0, 0, .6, .3, 0, 1}, {.25, 0, 0, .25, 0, .5, 1}}));
        QCOMPARE(valueOf(meeting, QStringLiteral("Open set condition")), QStringLiteral("unknown"));
        const auto segment = factsOf(fractalOf({{.9, 0, 0, .9, 0, 0, 1}, {.9, 0, 0, .9, 1, 0, 1}}));
        QVERIFY(valueOf(segment, QStringLiteral("Dimension of the measure"))
                    .startsWith(QStringLiteral("at most 1 ")));
    }

    // In the words of a report, with the digits of the panel.
    void boundsAreSaidAsInReports() {
        const QString radius = QStringLiteral("Joint spectral radius");
        QCOMPARE(valueOf(factsOf(maple()), radius), QStringLiteral("between 0.7074 and 0.7123"));
        for (const auto& fact : factsOf(document::sierpinskiTriangle()))
            if (fact.name == radius)
                QCOMPARE(fact.exact(), QStringLiteral("0.5")); // not between it and itself
    }
};

BARYCAGE_TEST(ProvedFactsTest, QApplication);
#include "proved_facts_test.moc"
