// SPDX-License-Identifier: MIT
#include "io/report/verdicts.h"

#include "ifs/system/iterated_function_system.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"

#include <QCoreApplication>
#include <QTest>

using namespace maps_support;

namespace {

QString sentenceOf(const document::Fractal& fractal) {
    const ifs::ActiveMaps<2> active = ifs::activeMaps(*document::system2(fractal));
    return io::verdictText(ifs::classify<2>(active.maps), active.index);
}

} // namespace

class VerdictsTest : public QObject {
    Q_OBJECT

private slots:
    // Map 1 is off, so the word that proves it must name map 2 as the table does.
    void namesTheMapThatExpandsByItsRow() {
        document::Fractal fractal = fractalOf({{0.5, 0, 0, 0.5, 0, 0, 1}, {2, 0, 0, 2, 1, 0, 1}});
        document::system2(fractal)->maps[0].enabled = false;
        const QString sentence = sentenceOf(fractal);
        QCOMPARE(sentence, QStringLiteral("none: ρ(A) ≥ 1 for the word 2"));
        document::system2(fractal)->maps[1].enabled = false;
        QVERIFY(sentenceOf(fractal).contains(QStringLiteral("no map is active")));
    }

    void theNormOfACertificateIsNamed() {
        ifs::Existence existence;
        existence.verdict = ifs::Verdict::EventuallyContractive;
        existence.contractivity = 0.7872;
        existence.norm = ifs::NormKind::Ellipsoidal;
        QCOMPARE(io::verdictText(existence, {0, 1}),
                 QStringLiteral("contractive in an ellipsoidal norm, γ = 0.7872"));
        existence.norm = ifs::NormKind::Polytope;
        QCOMPARE(io::verdictText(existence, {0, 1}),
                 QStringLiteral("contractive in a polytope norm, γ = 0.7872"));
        existence.norm = ifs::NormKind::Words;
        existence.wordLength = 4;
        QCOMPARE(io::verdictText(existence, {0, 1}),
                 QStringLiteral("eventually contractive, γ = 0.7872 from words of length 4"));
        const document::Fractal sheared = fractalOf({{0.5, 1.5, 0, 0.5, 0, 0, 1}, {0.5, 0, 0, 0.5, 1, 0, 1}});
        QCOMPARE(sentenceOf(sheared),
                 QStringLiteral("eventually contractive, γ = 0.932205 from words of length 4"));
    }

    void aFactorBelowOneNeverLooksLikeOne() {
        ifs::Existence existence;
        existence.verdict = ifs::Verdict::Hyperbolic;
        existence.contractivity = 0.9999999999;
        QCOMPARE(io::verdictText(existence, {}), QStringLiteral("hyperbolic, s = 0.9999999999"));
    }
};

BARYCAGE_TEST(VerdictsTest, QCoreApplication);
#include "verdicts_test.moc"
