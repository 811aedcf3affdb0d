// SPDX-License-Identifier: MIT
#include "main_window.h"
#include "support/own_settings.h"
#include "support/paths.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QTest>
#include <QUrl>

// A file dropped anywhere on the window is opened: on the canvas as on the panels.
class FileDropTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void aDroppedFileIsOpened_data();
    void aDroppedFileIsOpened();
};

namespace {

void drop(QWidget* target, const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    const QPoint middle = target->rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(target, &enter);
    QVERIFY(enter.isAccepted());
    QDragMoveEvent move(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    move.setAccepted(enter.isAccepted()); // as the window system leaves it
    QApplication::sendEvent(target, &move);
    QVERIFY(move.isAccepted());
    QDropEvent drop(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(target, &drop);
}

} // namespace

void FileDropTest::initTestCase() {
    support::useOwnSettings();
}

void FileDropTest::aDroppedFileIsOpened_data() {
    QTest::addColumn<QString>("panel");
    QTest::newRow("canvas") << QStringLiteral("view::CanvasView");
    QTest::newRow("maps") << QStringLiteral("view::MapsPanel");
    QTest::newRow("entries") << QStringLiteral("view::EntriesPanel");
    QTest::newRow("collection") << QStringLiteral("view::CollectionPanel");
}

void FileDropTest::aDroppedFileIsOpened() {
    QFETCH(QString, panel);
    auto* window = new MainWindow;
    window->resize(1300, 800);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    QList<QAbstractScrollArea*> targets;
    for (auto* area : window->findChildren<QAbstractScrollArea*>())
        for (const QWidget* above = area; above != window; above = above->parentWidget())
            if (panel == QLatin1String(above->metaObject()->className())) targets << area;
    QVERIFY(!targets.isEmpty());
    drop(targets.first()->viewport(), support::testData(QStringLiteral("shapes.ifs")));
    const QString before = window->windowTitle(); // whoever dropped it need not wait
    QVERIFY2(!before.startsWith(QStringLiteral("shapes.ifs")), qPrintable(before));
    QTRY_VERIFY2(window->windowTitle().startsWith(QStringLiteral("shapes.ifs")),
                 qPrintable(window->windowTitle()));
    window->close();
}

QTEST_MAIN(FileDropTest)
#include "file_drop_test.moc"
