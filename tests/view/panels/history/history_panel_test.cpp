// SPDX-License-Identifier: MIT
#include "panels/history/history_panel.h"
#include "support/named_test.h"

#include <QImage>
#include <QTest>
#include <QUndoView>

#include <algorithm>

using namespace Qt::StringLiterals;

class HistoryPanelTest : public QObject {
    Q_OBJECT

private slots:
    void stepsAndBack();
    void undoneStepsAreDimmed();
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

void HistoryPanelTest::undoneStepsAreDimmed() {
    document::Document document;
    for (const double gamma : {1.1, 1.2, 1.3}) {
        document::Fractal fractal = document.fractal();
        fractal.appearance.gamma = gamma;
        document.edit(u"The same text"_s, fractal);
    }
    view::HistoryPanel panel(&document);
    panel.resize(200, 200);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    auto* steps = panel.findChild<QUndoView*>();
    const auto contrast = [&](int row) {
        const QRect text = steps->visualRect(steps->model()->index(row, 0)).adjusted(24, 1, -1, -1);
        const QImage image = steps->viewport()->grab(text).toImage();
        int darkest = 255, lightest = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                darkest = std::min(darkest, qGray(image.pixel(x, y)));
                lightest = std::max(lightest, qGray(image.pixel(x, y)));
            }
        return lightest - darkest;
    };
    const int done = contrast(2);
    document.undoStack()->setIndex(1);
    QVERIFY2(contrast(2) < 0.8 * done, qPrintable(QString::number(contrast(2))));
    QVERIFY(contrast(2) > 0.2 * done); // still to be read
    document.undoStack()->setIndex(3);
    QCOMPARE(contrast(2), done);
}

BARYCAGE_TEST(HistoryPanelTest, QApplication);
#include "history_panel_test.moc"
