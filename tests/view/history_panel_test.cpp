// SPDX-License-Identifier: MIT
#include "panels/history_panel.h"

#include <QTest>
#include <QUndoView>

using namespace Qt::StringLiterals;

class HistoryPanelTest : public QObject {
    Q_OBJECT

private slots:
    void stepsAndBack();
};

void HistoryPanelTest::stepsAndBack() {
    document::Document document;
    view::HistoryPanel panel(&document);
    auto* steps = panel.findChild<QUndoView*>();
    QVERIFY(steps);
    QVERIFY(!steps->accessibleName().isEmpty());
    QVERIFY(!steps->cleanIcon().isNull());
    QCOMPARE(steps->model()->rowCount(), 1);

    const document::FractalFile opened = document.file();
    document::Fractal fractal = document.fractal();
    fractal.appearance.gamma = 1.1;
    document.edit(u"Change the gamma"_s, fractal);
    fractal.appearance.gamma = 1.2;
    document.edit(u"Change it again"_s, fractal);
    QCOMPARE(steps->model()->rowCount(), 3);
    QCOMPARE(steps->model()->index(1, 0).data().toString(), u"Change the gamma"_s);

    panel.resize(200, 200);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    const QModelIndex first = steps->model()->index(0, 0);
    QTest::mouseClick(steps->viewport(), Qt::LeftButton, {}, steps->visualRect(first).center());
    QVERIFY(document.file() == opened);
    QCOMPARE(document.undoStack()->index(), 0);
}

QTEST_MAIN(HistoryPanelTest)
#include "history_panel_test.moc"
