// SPDX-License-Identifier: MIT
#include "transformation/theft_sentences.h"

#include "ifs/tops/top_systems.h"

#include <QTest>

using document::CouplingFlaw;
using ifs::Homeomorphism;
using ifs::Tear;
using Place = std::array<ifs::Vector<2>, 2>;

// What the user reads of a fractal transformation.
class TheftSentencesTest : public QObject {
    Q_OBJECT

private slots:
    void continuityHasItsPlace() {
        const Tear torn{0.0041, Place{{{0.25, 0.5}, {0.25, 0.7}}}, false};
        QCOMPARE(view::sentenceOf(torn), QStringLiteral("Continuous to 0.0041, worst at (0.25, 0.6)"));
        Tear bound = torn;
        bound.isCutShort = true;
        QCOMPARE(view::sentenceOf(bound),
                 QStringLiteral("Continuous to 0.0041 or better, worst at (0.25, 0.6)"));
        QCOMPARE(view::sentenceOf(Tear{}), QStringLiteral("Continuous: the pieces do not touch"));
    }

    // A homeomorphism to the larger of both tears, with the place in the partner.
    void bothWaysCount() {
        const Tear small{0.0041, Place{{{0.25, 0.5}, {0.25, 0.7}}}, false};
        const Tear large{0.33, Place{{{0.5, 0}, {1.5, 0}}}, false};
        const auto unknown = Homeomorphism::Unknown;
        QCOMPARE(view::sentenceOf(small, large, unknown),
                 QStringLiteral("Homeomorphism to 0.33, worst on the way back at (1, 0)"));
        QCOMPARE(view::sentenceOf(large, small, unknown),
                 QStringLiteral("Homeomorphism to 0.33, worst on the way back at (0.25, 0.6)"));
        QCOMPARE(view::sentenceOf(small, Tear{}, unknown), QStringLiteral("Homeomorphism to 0.0041"));
        Tear bound = large;
        bound.isCutShort = true;
        QCOMPARE(view::sentenceOf(small, bound, unknown),
                 QStringLiteral("Homeomorphism to 0.33 or better, worst on the way back at (1, 0)"));
    }

    // The interval, once torn into dust and once glued.
    void verdictsAreSaid() {
        const auto whole = tops::attractorOf(tops::interval(0.5)), dust = tops::attractorOf(tops::cantor());
        const Tear there = ifs::tear(whole, dust, 0.01), back = ifs::tear(dust, whole, 0.01);
        QVERIFY(there.place && !back.place);
        QCOMPARE(view::sentenceOf(there, back, ifs::homeomorphism(whole, dust)),
                 QStringLiteral("Not a homeomorphism"));
        const QString torn = view::sentenceOf(back, there, ifs::homeomorphism(dust, whole));
        QVERIFY2(torn.startsWith(QStringLiteral("Not a homeomorphism: torn by 0.")), qPrintable(torn));
        QVERIFY2(torn.contains(QStringLiteral("worst at (0.")), qPrintable(torn));
        QCOMPARE(view::sentenceOf(back, back, ifs::homeomorphism(dust, dust)),
                 QStringLiteral("A homeomorphism, as is proved"));
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

QTEST_APPLESS_MAIN(TheftSentencesTest)
#include "theft_sentences_test.moc"
