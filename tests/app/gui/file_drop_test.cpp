// SPDX-License-Identifier: MIT
#include "document/fractal_geometry.h"
#include "io/picture/png_export.h"
#include "main_window.h"
#include "panels/collage/collage_panel.h"
#include "panels/collage/target_box.h"
#include "support/own_settings.h"
#include "support/paths.h"
#include "support/patient_tries.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QImage>
#include <QMimeData>
#include <QTemporaryDir>
#include <QUrl>

// A file dropped anywhere on the window is opened: on the canvas as on the panels.
class FileDropTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void aDroppedFileIsOpened_data();
    void aDroppedFileIsOpened();
    void aDroppedPictureIsATarget();
    void aDroppedPictureWithASystemIsOpened();
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

// Nothing is opened, so nothing is asked about unsaved work.
void FileDropTest::aDroppedPictureIsATarget() {
    const QTemporaryDir folder;
    QImage leaf(64, 64, QImage::Format_RGB32);
    leaf.fill(Qt::white);
    for (int y = 16; y < 48; ++y)
        for (int x = 20; x < 40; ++x)
            leaf.setPixel(x, y, qRgb(0, 40, 0));
    QVERIFY(leaf.save(folder.filePath(QStringLiteral("leaf.png"))));
    auto* window = new MainWindow;
    window->resize(1300, 800);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    auto* dock = window->findChild<QDockWidget*>(QStringLiteral("collage"));
    QVERIFY(dock->isHidden());
    const QString title = window->windowTitle();
    auto* canvas = window->findChild<view::CanvasView*>();
    drop(canvas->viewport(), folder.filePath(QStringLiteral("leaf.png")));
    auto* panel = window->findChild<view::CollagePanel*>();
    QTRY_VERIFY(panel->target()->traced());
    QVERIFY(dock->isVisible());
    QCOMPARE(collage::area(panel->target()->traced()->mask), std::size_t{32 * 20});
    QCOMPARE(window->windowTitle(), title);
    window->close(); // while it is measured
}

void FileDropTest::aDroppedPictureWithASystemIsOpened() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("maple.png"));
    io::PngExport request;
    request.fractal = document::sierpinskiTriangle();
    request.fractal.name = QStringLiteral("dropped");
    attractor::Camera camera;
    camera.width = camera.height = 64;
    request.request = document::renderRequest(request.fractal, camera);
    QVERIFY(!io::exportPng(request, path).failure);
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    drop(window, path);
    QTRY_COMPARE(window->document().fractal().name, request.fractal.name);
    QVERIFY(!window->findChild<view::CollagePanel*>()->target()->traced());
    window->close();
}

QTEST_MAIN(FileDropTest)
#include "file_drop_test.moc"
