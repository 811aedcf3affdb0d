// SPDX-License-Identifier: MIT
#include "transformation/theft_sentences.h"

#include "ifs/tops/top_systems.h"
#include "support/named_test.h"

#include <QTest>

#include <optional>

using document::CouplingFlaw;
using ifs::Homeomorphism;
using ifs::Tear;
using Place = std::array<ifs::Vector<2>, 2>;

// What the user reads of a fractal transformation.
class TheftSentencesTest : public QObject {
    Q_OBJECT

private slots:
    // What is said is a bound that is proved, with its share of the whole and its place.
    void boundsHaveTheirPlace() {
        const Tear torn{0.0041, Place{{{0.25, 0.5}, {0.25, 0.7}}}, false, 4.1};
        QCOMPARE(view::sentenceOf(torn),
                 QStringLiteral("Proved: no jump between pieces exceeds 0.0041 (0.1 % of "
                                "the partner), worst near (0.25, 0.6)"));
        Tear bound = torn;
        bound.isCutShort = true;
        bound.size = bound.whole; // nothing better than the whole is known
        QCOMPARE(view::sentenceOf(bound),
                 QStringLiteral("Proved so far: no jump between pieces exceeds 4.1 (100 % of "
                                "the partner), worst near (0.25, 0.6)"));
        QCOMPARE(view::sentenceOf(Tear{}), QStringLiteral("Proved continuous: the pieces do not touch"));
        const Tear none{2, std::nullopt, true, 2}; // nothing was looked at
        QCOMPARE(view::sentenceOf(none), QStringLiteral("Too many maps to bound the jumps"));
    }

    // Nothing is called a homeomorphism that is not proved to be one.
    void theWayBackIsBoundedToo() {
        const Tear large{0.33, Place{{{0.5, 0}, {1.5, 0}}}, false, 1};
        const auto unknown = Homeomorphism::Unknown;
        QCOMPARE(
            view::sentenceOf(large, unknown),
            QStringLiteral("Not known whether it is a homeomorphism; no jump back exceeds 0.33 (33 % of this "
                           "fractal), worst near (1, 0)"));
        QCOMPARE(view::sentenceOf(Tear{}, unknown),
                 QStringLiteral("Not known whether it is a homeomorphism"));
        QCOMPARE(view::sentenceOf(large, Homeomorphism::Refuted),
                 QStringLiteral(
                     "Proved not to be a homeomorphism; no jump back exceeds 0.33 (33 % of this fractal), "
                     "worst near (1, 0)"));
    }

    // The interval, once torn into dust and once glued.
    void verdictsAreSaid() {
        const auto whole = tops::attractorOf(tops::interval(0.5)), dust = tops::attractorOf(tops::cantor());
        const Tear there = ifs::tear(whole, dust, 0.01), back = ifs::tear(dust, whole, 0.01);
        QVERIFY(there.place && !back.place);
        QVERIFY(there.size < there.whole && there.whole < 1.1); // the dust is as long as the interval
        QCOMPARE(view::sentenceOf(back, ifs::homeomorphism(whole, dust)),
                 QStringLiteral("Proved not to be a homeomorphism"));
        const QString torn = view::sentenceOf(there, ifs::homeomorphism(dust, whole));
        QVERIFY2(torn.startsWith(QStringLiteral("Proved not to be a homeomorphism; no jump back exceeds 0.")),
                 qPrintable(torn));
        QVERIFY2(torn.contains(QStringLiteral("worst near (0.")), qPrintable(torn));
        QCOMPARE(view::sentenceOf(back, ifs::homeomorphism(dust, dust)),
                 QStringLiteral("Proved to be a homeomorphism"));
    }

    void bentCagesAreRefused() {
        document::CouplingOutcome flaw;
        flaw.flaw = CouplingFlaw::BentCage;
        const QString from = QStringLiteral("fern"), to = QStringLiteral("maple");
        QCOMPARE(view::sentenceOf(flaw, from, to),
                 QStringLiteral("The cage of “fern” is flat or bends the picture. Bake or reset it first."));
        flaw.isOfSecond = true;
        QVERIFY(view::sentenceOf(flaw, from, to).contains(QStringLiteral("“maple”")));
    }
};

BARYCAGE_TEST(TheftSentencesTest);
#include "theft_sentences_test.moc"
