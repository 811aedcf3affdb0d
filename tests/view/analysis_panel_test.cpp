// SPDX-License-Identifier: MIT
#include "panels/analysis_panel.h"
#include "view/maps_support.h"

#include <QClipboard>
#include <QGuiApplication>

#include <memory>

using namespace maps_support;

class AnalysisPanelTest : public QObject {
    Q_OBJECT

private slots:
    void knowsThePublishedFactsOfTheMaple() {
        const auto facts = view::analysisFacts(maple());
        QCOMPARE(valueOf(facts, QStringLiteral("Contraction")),
                 QStringLiteral("0.6896  0.61  0.7225  0.7232"));
        QCOMPARE(valueOf(facts, QStringLiteral("Canonical simplex")),
                 QStringLiteral("(−, −), leg 11.7047, corner (3.3442, 5.0725)"));
        QCOMPARE(valueOf(facts, QStringLiteral("Mean")), QStringLiteral("(0.0728, 1.4312)"));
        QCOMPARE(valueOf(facts, QStringLiteral("Covariance")), QStringLiteral("1.0709, -0.0524, 3.7828"));
        QVERIFY(valueOf(facts, QStringLiteral("Attractor")).contains(QStringLiteral("hyperbolic")));
        QVERIFY(valueOf(facts, QStringLiteral("Box")).startsWith(QStringLiteral("[-3.3001, 3.3442]")));
        QVERIFY(valueOf(facts, QStringLiteral("Similarity dimension")).isEmpty());
    }

    void knowsTheDimensionOfTheSierpinskiTriangle() {
        const auto facts = view::analysisFacts(document::sierpinskiTriangle());
        QCOMPARE(valueOf(facts, QStringLiteral("Similarity dimension")), QStringLiteral("1.585"));
    }

    // Map 1 is off, so the word that proves it must name map 2 as the table does.
    void namesTheMapThatExpandsByItsRow() {
        document::Fractal fractal = fractalOf({{0.5, 0, 0, 0.5, 0, 0, 1}, {2, 0, 0, 2, 1, 0, 1}});
        document::system2(fractal)->maps[0].enabled = false;
        const QString sentence = view::existenceSentence(*document::system2(fractal));
        QVERIFY2(sentence.startsWith(QStringLiteral("None: the word 2 ")), qPrintable(sentence));
        document::system2(fractal)->maps[1].enabled = false;
        QVERIFY(view::existenceSentence(*document::system2(fractal))
                    .contains(QStringLiteral("no map takes part")));
    }

    void computesOnlyWhenVisibleAndFollows() {
        document::Document document;
        document.setFile(document::fileOf(maple()));
        view::AnalysisPanel panel(&document);
        QTest::qWait(300);
        QVERIFY(panel.facts().isEmpty());
        panel.show();
        QTRY_VERIFY(!panel.facts().isEmpty());
        QVERIFY(panel.isVisible());
        document.edit(QStringLiteral("x"), document::sierpinskiTriangle());
        QTRY_COMPARE(valueOf(panel.facts(), QStringLiteral("Similarity dimension")), QStringLiteral("1.585"));
        panel.copyAll();
        QVERIFY(QGuiApplication::clipboard()->text().contains(
            QStringLiteral("Similarity dimension\t1.58496250072115")));
    }

private:
    static QString valueOf(const QList<view::Fact>& facts, const QString& name) {
        for (const auto& fact : facts)
            if (fact.name == name) return fact.value;
        return {};
    }
};

QTEST_MAIN(AnalysisPanelTest)
#include "analysis_panel_test.moc"
