// SPDX-License-Identifier: MIT
#include "panels/analysis/existence_sentence.h"

#include "ifs/system/iterated_function_system.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"

#include <QTest>

using namespace maps_support;

namespace {

QString sentenceOf(const document::Fractal& fractal) {
    const ifs::ActiveMaps<2> active = ifs::activeMaps(*document::system2(fractal));
    return view::existenceSentence(ifs::classify<2>(active.maps), active.index);
}

} // namespace

class ExistenceSentenceTest : public QObject {
    Q_OBJECT

private slots:
    // Map 1 is off, so the word that proves it must name map 2 as the table does.
    void namesTheMapThatExpandsByItsRow() {
        document::Fractal fractal = fractalOf({{0.5, 0, 0, 0.5, 0, 0, 1}, {2, 0, 0, 2, 1, 0, 1}});
        document::system2(fractal)->maps[0].enabled = false;
        const QString sentence = sentenceOf(fractal);
        QVERIFY2(sentence.startsWith(QStringLiteral("None: map 2 ")), qPrintable(sentence));
        document::system2(fractal)->maps[1].enabled = false;
        QVERIFY(sentenceOf(fractal).contains(QStringLiteral("no map is active")));
    }

    // A shear that no norm of the plane but an ellipse sees contract, and two maps that only do so in turn.
    void aCertificateIsSaidInPlainWords() {
        ifs::Existence existence;
        existence.verdict = ifs::Verdict::EventuallyContractive;
        existence.contractivity = 0.7872;
        existence.norm = ifs::NormKind::Ellipsoidal;
        QString sentence = view::existenceSentence(existence, {0, 1});
        QVERIFY2(sentence.contains(QStringLiteral("norm")), qPrintable(sentence));
        QVERIFY2(!sentence.contains(QStringLiteral("in a row")), qPrintable(sentence));
        existence.norm = ifs::NormKind::Words;
        existence.wordLength = 4;
        sentence = view::existenceSentence(existence, {0, 1});
        QVERIFY2(sentence.contains(QStringLiteral("any 4 maps in a row contract")), qPrintable(sentence));
        QVERIFY(sentence.contains(QStringLiteral("0.7872")));

        const document::Fractal sheared = fractalOf({{0.5, 1.5, 0, 0.5, 0, 0, 1}, {0.5, 0, 0, 0.5, 1, 0, 1}});
        sentence = sentenceOf(sheared);
        QVERIFY2(sentence.startsWith(QStringLiteral("Yes: ")), qPrintable(sentence));
        QVERIFY2(!sentence.contains(QStringLiteral(" 1 maps")), qPrintable(sentence));
    }
};

BARYCAGE_TEST(ExistenceSentenceTest, QApplication);
#include "existence_sentence_test.moc"
