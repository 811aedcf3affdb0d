// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "io/picture/plane_export.h"
#include "main_window.h"
#include "panels/collage/collage_panel.h"
#include "panels/collage/target_box.h"
#include "session/session.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/paths.h"
#include "support/patient_tries.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressDialog>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QUrl>

#include <algorithm>

// A file dropped anywhere on the window is opened: on the canvas as on the panels.
class FileDropTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void aDroppedFileIsOpened_data();
    void aDroppedFileIsOpened();
    void aDroppedPictureIsATarget();
    void aTargetIsNotLostSilently();
    void aDroppedPictureWithASystemIsOpened();
    void aDroppedFileIsNotMoved();
    void manyDroppedFilesAreAskedAbout_data();
    void manyDroppedFilesAreAskedAbout();
    void manyFilesAreCancelled();
    void manyBrokenFilesAreSaidTogether();
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

// It is not saved, and the question about unsaved changes says so.
void FileDropTest::aTargetIsNotLostSilently() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    document::Fractal renamed = window->document().fractal();
    renamed.name = QStringLiteral("renamed");
    window->document().edit(QStringLiteral("Rename"), renamed);
    QString said;
    const auto closeWith = [&](QMessageBox::StandardButton answer) {
        said.clear();
        QTimer::singleShot(0, window, [&said, answer] {
            for (QWidget* widget : QApplication::topLevelWidgets())
                if (auto* box = qobject_cast<QMessageBox*>(widget); box && box->isVisible()) {
                    said = box->informativeText();
                    box->button(answer)->click();
                }
        });
        window->close();
    };
    closeWith(QMessageBox::Cancel);
    QVERIFY2(said.contains(QStringLiteral("save them")), qPrintable(said));
    QVERIFY2(!said.contains(QStringLiteral("target")), qPrintable(said));
    auto* panel = window->findChild<view::CollagePanel*>();
    panel->target()->take(window->document().sharedFractal());
    QTRY_VERIFY(panel->target()->traced());
    closeWith(QMessageBox::Cancel);
    QVERIFY2(said.contains(QStringLiteral("target in the Collage panel is not saved")), qPrintable(said));
    closeWith(QMessageBox::Discard);
}

void FileDropTest::aDroppedPictureWithASystemIsOpened() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("maple.png"));
    io::PlaneExport request;
    request.fractal = document::sierpinskiTriangle();
    request.fractal.name = QStringLiteral("dropped");
    attractor::Camera camera;
    camera.width = camera.height = 64;
    request.request = document::renderRequest(request.fractal, camera);
    QVERIFY(!io::exportPlane(request, path).failure);
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    drop(window, path);
    QTRY_COMPARE(window->document().fractal().name, request.fractal.name);
    QVERIFY(!window->findChild<view::CollagePanel*>()->target()->traced());
    window->close();
}

// Else a file manager would delete it: Shift asks for a move.
void FileDropTest::aDroppedFileIsNotMoved() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(support::testData(QStringLiteral("shapes.ifs")))});
    const QPoint middle = window->rect().center();
    const Qt::DropActions offered = Qt::CopyAction | Qt::MoveAction;
    QDragEnterEvent enter(middle, offered, &data, Qt::LeftButton, Qt::ShiftModifier);
    enter.setDropAction(Qt::MoveAction);
    QApplication::sendEvent(window, &enter);
    QVERIFY(enter.isAccepted());
    QCOMPARE(enter.dropAction(), Qt::CopyAction);
    QDropEvent drop(middle, offered, &data, Qt::LeftButton, Qt::ShiftModifier);
    drop.setDropAction(Qt::MoveAction);
    QApplication::sendEvent(window, &drop);
    QVERIFY(drop.isAccepted());
    QCOMPARE(drop.dropAction(), Qt::CopyAction);
    QTRY_VERIFY(window->windowTitle().startsWith(QStringLiteral("shapes.ifs")));
    window->close();
}

namespace {

QStringList copies(const QTemporaryDir& folder, int count) {
    QStringList paths;
    for (int i = 0; i < count; ++i) {
        paths << folder.filePath(QStringLiteral("%1.ifs").arg(i));
        QFile::copy(support::testData(QStringLiteral("shapes.ifs")), paths.last());
    }
    return paths;
}

int openWindows(const QStringList& paths) {
    int count = 0;
    for (const SessionWindow* window : session::windows())
        if (window->isVisible() && paths.contains(window->path())) ++count;
    return count;
}

void closeAll() {
    for (SessionWindow* window : session::windows())
        window->close();
}

} // namespace

void FileDropTest::manyDroppedFilesAreAskedAbout_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<int>("opened");
    QTest::addColumn<int>("count");
    QTest::newRow("all") << QByteArray("all") << 12 << 12;
    QTest::newRow("some") << QByteArray("some") << 8 << 12;
    QTest::newRow("none") << QByteArray() << 0 << 12;
    QTest::newRow("nine") << QByteArray() << 0 << 9;
    QTest::newRow("eight, without a question") << QByteArray() << 8 << 8;
}

void FileDropTest::manyDroppedFilesAreAskedAbout() {
    QFETCH(const QByteArray, answer);
    QFETCH(const int, opened);
    QFETCH(const int, count);
    const QTemporaryDir folder;
    const QStringList paths = copies(folder, count);
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths)
        urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    QString asked;
    QTimer answering;
    connect(&answering, &QTimer::timeout, &answering, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box) return;
        asked = box->text();
        answer.isEmpty() ? box->reject() : support::button(*box, answer.constData())->click();
    });
    answering.start(10);
    const QPoint middle = window->rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window, &enter);
    QDropEvent drop(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window, &drop);
    QTRY_COMPARE_WITH_TIMEOUT(openWindows(paths), opened, 60'000);
    QTRY_COMPARE(asked, count > 8 ? QStringLiteral("Open %1 files?").arg(count) : QString());
    QCOMPARE(session::windows().size(), std::max(opened, 1));
    closeAll();
}

void FileDropTest::manyFilesAreCancelled() {
    const QTemporaryDir folder;
    const QStringList paths = copies(folder, 12);
    QTimer cancelling;
    connect(&cancelling, &QTimer::timeout, &cancelling, [&] {
        if (openWindows(paths) < 2) return;
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* progress = qobject_cast<QProgressDialog*>(widget); progress && progress->isVisible())
                emit progress->canceled();
    });
    cancelling.start(0);
    MainWindow::openEach(paths);
    QCOMPARE(openWindows(paths), 2);
    QCOMPARE(session::windows().size(), 2);
    closeAll();
}

// Nobody closes a box for each.
void FileDropTest::manyBrokenFilesAreSaidTogether() {
    const QTemporaryDir folder;
    QStringList paths;
    for (int i = 10; i < 40; ++i) {
        paths << folder.filePath(QStringLiteral("%1.ifs").arg(i));
        QFile file(paths.last());
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no fractal") > 0);
    }
    MainWindow::openEach(paths);
    QCOMPARE(session::windows().size(), 1);
    const auto boxes = session::windows().first()->findChildren<QMessageBox*>();
    QCOMPARE(boxes.size(), 2);
    QString said;
    for (const QMessageBox* box : boxes) {
        said += box->text() + box->informativeText() + box->detailedText();
        QVERIFY(box->informativeText().count(u'\n') < 10);
    }
    for (const QString& path : paths)
        QVERIFY2(said.contains(QFileInfo(path).fileName()), qPrintable(path));
    boxes.first()->accept();
    QVERIFY(boxes.last()->isVisible());
    boxes.last()->accept();
    closeAll();
}

BARYCAGE_TEST(FileDropTest, QApplication);
#include "file_drop_test.moc"
