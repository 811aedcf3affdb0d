// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "desktop/preferences.h"
#include "dialogs/paste_table_dialog.h"
#include "dialogs/preferences_dialog.h"
#include "files/recovery.h"
#include "messages/flame_banner.h"
#include "panels/collection/collection_panel.h"
#include "panels/entries/entries_panel.h"
#include "panels/maps/maps_panel.h"
#include "panels/timeline/timeline_panel.h"
#include "session/session.h"
#include "session_fixture.h"
#include "space/four_views.h"
#include "space/space_view.h"
#include "stage/stage.h"
#include "support/choose.h"
#include "support/commands.h"
#include "support/forget_settings.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QStatusBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolBar>
#include <QUndoStack>

#include <algorithm>
#include <vector>

// The window as a whole: what it opens, and what reaches it from elsewhere.
class MainWindowTest : public SessionFixture {
    Q_OBJECT

private slots:
    void brokenPathsShareOneWindow();
    void saysWhenWorkCannotBeKept();
    void preferencesReachEveryWindow();
    void preferencesKnowWhatIsNotSaved();
    void theFilesOfTheLastRunAreKnown();
    void theColumnsOfATableAreAskedFor();
    void windowsHaveTheirOwnDocuments();
    void whatOthersCopiedIsPasted();
    void theHintGoesWithAnotherTool();
    void aKeyLeadsFromThePanelsToTheCanvasAndBack();
    void mapsInSpaceStaySelected();
    void theCameraInSpaceIsKeyed();
    void framesAreKeyedFromTheCanvas();
    void spaceOnTheBallOfAxesDoesNotPlay();
    void theViewIsRotated();
    void flamesAreReadEitherWayUp();
    void theMenuCopiesAsLatex();
    void aFractalOfTheCollectionBecomesADocument();
    void theMapsAreNumberedOnTheCanvas();
};

void MainWindowTest::brokenPathsShareOneWindow() {
    const QString good = support::testData(QStringLiteral("shapes.ifs"));
    MainWindow::openEach({QStringLiteral("/nowhere/a.ifs"), QStringLiteral("/nowhere/b.ifs"),
                          QStringLiteral("/nowhere/c.ifs")});
    QCOMPARE(windows().size(), 1);
    QString said;
    for (const auto* box : windows().first()->findChildren<QMessageBox*>())
        said += box->text() + box->informativeText();
    for (const char* name : {"a.ifs", "b.ifs", "c.ifs"}) // each is reported
        QVERIFY2(said.contains(QLatin1String(name)), qPrintable(said));
    closeWindows();

    const QString other = support::testData(QStringLiteral("dos.ifs"));
    MainWindow::openEach({QStringLiteral("/nowhere/a.ifs"), good, other});
    QCOMPARE(windows().size(), 2);
    for (SessionWindow* window : windows())
        QVERIFY(window->path() == good || window->path() == other);
}

// A file is in the place of the recovery folder; recovered work is not deleted before it is kept again.
void MainWindowTest::saysWhenWorkCannotBeKept() {
    const QTemporaryDir old;
    const QString journal = old.filePath(QStringLiteral("old.journal"));
    QFile(journal).open(QIODevice::WriteOnly);
    QDir(Recovery::folder()).removeRecursively();
    QDir().mkpath(QFileInfo(Recovery::folder()).path());
    QFile inTheWay(Recovery::folder());
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    auto* window = new MainWindow;
    window->openRecovered({journal, {{}, QStringLiteral("old"), 0, {}, "a { .5 0 0 .5 0 0 1 }\n", {}}, {}});
    QTRY_COMPARE(window->findChildren<QMessageBox*>().size(), 1);
    const auto boxes = window->findChildren<QMessageBox*>();
    QVERIFY(boxes.first()->informativeText().contains(QStringLiteral("cannot be kept")));
    QVERIFY(QFile::exists(journal));
    inTheWay.remove();
}

void MainWindowTest::preferencesReachEveryWindow() {
    view::Preferences preferences;
    preferences.quality = 50'000'000;
    preferences.store();
    MainWindow* first = shown({});
    MainWindow* second = shown({});
    const auto quality = [](MainWindow* window) {
        return window->findChild<view::RenderBridge*>()->quality();
    };
    QCOMPARE(quality(first), std::uint64_t(50'000'000));
    for (QAction* action : first->findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+,"))) action->trigger();
    auto* dialog = first->findChild<view::PreferencesDialog*>();
    QVERIFY(dialog);
    for (auto* box : dialog->findChildren<QComboBox*>())
        if (box->accessibleName() == QStringLiteral("Picture at rest"))
            support::choose(box, quint64(1'000'000'000));
    QCOMPARE(quality(first), std::uint64_t(1'000'000'000));
    QCOMPARE(quality(second), std::uint64_t(1'000'000'000));
    QCOMPARE(quality(shown({})), std::uint64_t(1'000'000'000));
    view::Preferences{}.store();
}

// In all windows: a restart closes them all.
void MainWindowTest::preferencesKnowWhatIsNotSaved() {
    MainWindow* first = shown(support::testData(QStringLiteral("shapes.ifs")));
    MainWindow* second = shown(support::testData(QStringLiteral("dos.ifs")));
    document::Fractal changed = second->document().fractal();
    changed.name = QStringLiteral("other");
    second->document().edit(QStringLiteral("rename"), changed);
    QTRY_VERIFY(second->isWindowModified());
    QVERIFY(!first->isWindowModified());
    for (QAction* action : first->findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+,"))) action->trigger();
    const auto* dialog = first->findChild<view::PreferencesDialog*>();
    QVERIFY(dialog);
    QString said;
    for (const auto* label : dialog->findChildren<QLabel*>())
        if (label->text().contains(QStringLiteral("Restart"))) said = label->text();
    QVERIFY2(said.contains(QStringLiteral("dos.ifs")), qPrintable(said));
    QVERIFY2(!said.contains(QStringLiteral("shapes.ifs")), qPrintable(said));
    QVERIFY2(!said.contains(u'['), qPrintable(said));
}

void MainWindowTest::theFilesOfTheLastRunAreKnown() {
    const QString shapes = support::testData(QStringLiteral("shapes.ifs"));
    const QString dos = support::testData(QStringLiteral("dos.ifs"));
    const auto known = [] {
        QStringList files = session::files();
        files.sort();
        return files;
    };
    shown(shapes);
    shown(dos);
    shown({}); // without a file
    session::quit();
    QCOMPARE(known(), QStringList({dos, shapes}));
    closeWindows();

    shown(shapes);
    shown(dos);
    QVERIFY(!session::filesToReopen());
    session::restart();
    QVERIFY(session::filesToReopen());
    QStringList again = *session::filesToReopen();
    again.sort();
    QCOMPARE(again, QStringList({dos, shapes}));
    for (const SessionWindow* window : windows())
        QVERIFY(!window->isVisible());
    closeWindows();

    MainWindow* first = shown(shapes);
    MainWindow* last = shown(dos);
    first->close();
    last->close();
    QCOMPARE(known(), QStringList({dos}));
    view::finishStoring();
    QSettings().setValue(QStringLiteral("session/files"), QStringList({QStringLiteral("/nowhere/a.ifs")}));
    QVERIFY(session::files().isEmpty());
}

// Of a file that does not say what its columns are.
void MainWindowTest::theColumnsOfATableAreAskedFor() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("leaf.csv"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("0.5,0.1,3,0.2,0.4,5,0.25\n0.3,0,2,0,0.3,1,0.75\n");
    file.close();
    MainWindow* window = shown(path);
    auto* dialog = window->findChild<view::PasteTableDialog*>();
    QVERIFY(dialog);
    auto& document = window->document();
    const auto shift = [&] { return document::system2(document.fractal())->maps[0].map.translation.x(); };
    QCOMPARE(shift(), 3.0); // the first order in which every map contracts
    dialog->reject();
    QCOMPARE(shift(), 0.4); // Fractint's
    QCOMPARE(document.undoStack()->count(), 0);

    QVERIFY(window->openPath(path));
    for (auto* open : window->findChildren<view::PasteTableDialog*>())
        if (open->isVisible()) open->accept();
    QCOMPARE(shift(), 3.0);
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(document::system2(document.fractal())->maps.size(), std::size_t(2));
}

void MainWindowTest::windowsHaveTheirOwnDocuments() {
    MainWindow* first = shown(support::testData(QStringLiteral("shapes.ifs")));
    QVERIFY(QTest::qWaitForWindowActive(first));
    QTest::keyClick(first, Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(windows().size(), 2);
    auto* second = qobject_cast<MainWindow*>(windows()[windows().first() == first ? 1 : 0]);
    QVERIFY(second->isVisible());
    QVERIFY(second->pos() != first->pos()); // both can be seen
    QVERIFY(second->path().isEmpty());
    document::Fractal changed = second->document().fractal();
    changed.name = QStringLiteral("other");
    second->document().edit(QStringLiteral("rename"), changed);
    QCOMPARE(first->document().undoStack()->count(), 0);
    QVERIFY(first->document().fractal().name != changed.name);
    second->document().undoStack()->undo();
    second->close();
    QTRY_COMPARE(windows().size(), 1);
    QVERIFY(first->isVisible());
}

// Wherever the focus is, but in a field.
void MainWindowTest::whatOthersCopiedIsPasted() {
    MainWindow* window = shown(support::testData(QStringLiteral("shapes.ifs")));
    QVERIFY(QTest::qWaitForWindowActive(window));
    const auto paste = [&](const QString& text) {
        QGuiApplication::clipboard()->setText(text);
        window->findChild<view::CanvasView*>()->setFocus();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_V, Qt::ControlModifier);
        return window->document().fractal();
    };
    const auto entries = [&] { return window->document().file().entries.size(); };
    const qsizetype before = entries();
    QCOMPARE(paste(QStringLiteral("guest { .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5 }")).name,
             QStringLiteral("guest"));
    QCOMPARE(entries(), before + 1);
    QCOMPARE(paste(QStringLiteral("<flame name=\"ember\"><xform weight=\"1\" linear=\"1\" "
                                  "coefs=\"0.5 0 0 0.5 0 0\"/></flame>"))
                 .name,
             QStringLiteral("ember"));
    QCOMPARE(entries(), before + 2);
    QCOMPARE(document::system2(paste(QStringLiteral(".5 0 0 .5 0 0 .5\n.5 0 0 .5 .5 0 .5\n")))->maps.size(),
             std::size_t(2));
    QCOMPARE(entries(), before + 3);
}

void MainWindowTest::theHintGoesWithAnotherTool() {
    using Tool = view::CanvasView::Tool;
    support::forgetSettings();
    for (const bool byTool : {true, false}) {
        for (const bool isFirst : {true, false}) {
            auto* window = new MainWindow;
            window->openFirstPicture();
            window->show();
            QVERIFY(QTest::qWaitForWindowExposed(window));
            auto* canvas = window->findChild<view::CanvasView*>();
            QCOMPARE(!canvas->hint().isEmpty(), isFirst); // not a second time
            if (isFirst && byTool) canvas->setTool(Tool::Maps);
            if (isFirst && !byTool) canvas->navigation().zoomBy(1.25);
            QVERIFY(canvas->hint().isEmpty());
            canvas->setTool(Tool::Cage);
            QVERIFY(canvas->hint().isEmpty());
            delete window;
        }
        support::forgetSettings();
    }
}

void MainWindowTest::aKeyLeadsFromThePanelsToTheCanvasAndBack() {
    MainWindow* window = shown(support::testData(QStringLiteral("shapes.ifs")));
    QVERIFY(QTest::qWaitForWindowActive(window));
    const auto* canvas = window->findChild<view::CanvasView*>();
    auto* maps = window->findChild<QDockWidget*>(QStringLiteral("maps"))->findChild<QTableView*>();
    auto* entries = window->findChild<QDockWidget*>(QStringLiteral("entries"))->findChild<QListView*>();
    auto* collection = window->findChild<QDockWidget*>(QStringLiteral("collection"));
    auto* tools = window->findChild<QToolBar*>(QStringLiteral("tools"));
    window->findChild<QDockWidget*>(QStringLiteral("problems"))->hide();
    window->findChild<view::CanvasView*>()->setFocus();
    QTRY_VERIFY(canvas->hasFocus());
    const auto focusIn = [](const QWidget* part) {
        return part == QApplication::focusWidget() || part->isAncestorOf(QApplication::focusWidget());
    };
    const QList<const QWidget*> order{entries->window()->findChild<QDockWidget*>(QStringLiteral("entries")),
                                      collection, window->findChild<QDockWidget*>(QStringLiteral("maps")),
                                      tools, canvas};
    for (const QWidget* part : order) {
        QTest::keyClick(window->focusWidget(), Qt::Key_F6);
        QVERIFY2(focusIn(part), qPrintable(part->objectName()));
    }
    for (qsizetype i = order.size() - 2; i >= 0; --i) {
        QTest::keyClick(window->focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
        QVERIFY2(focusIn(order[i]), qPrintable(order[i]->objectName()));
    }
    // Back where it was in a panel, and the canvas shows that it has the keyboard.
    maps->setFocus();
    QTest::keyClick(maps, Qt::Key_F6, Qt::ShiftModifier);
    QTest::keyClick(window->focusWidget(), Qt::Key_F6);
    QVERIFY(maps->hasFocus());
    auto* view = window->findChild<view::CanvasView*>();
    const QImage without = view->viewport()->grab({0, 0, 8, 8}).toImage();
    view->setFocus(Qt::TabFocusReason);
    QTRY_VERIFY(view->hasFocus());
    QVERIFY(view->viewport()->grab({0, 0, 8, 8}).toImage() != without);
}

// The canvas of the plane selects no maps of space, and takes none from the table.
void MainWindowTest::mapsInSpaceStaySelected() {
    MainWindow* window = shown(support::testData(QStringLiteral("shapes.ifs")));
    auto* maps = window->findChild<view::MapsPanel*>();
    QVERIFY(!maps->selectedMaps().empty());
    document::Fractal solid = pairOfCubes();
    const document::System3 system = *document::system3(solid);
    document::Document& document = window->document();
    document.edit(QStringLiteral("solid"), solid);
    for (const auto& map : system.maps) {
        maps->selectMaps({map.id});
        QCOMPARE(maps->selectedMaps(), std::vector{map.id});
        document::system3(solid)->maps[0].map.translation.x() += 0.25;
        document.edit(QStringLiteral("change"), solid);
        QCOMPARE(maps->selectedMaps(), std::vector{map.id});
    }
    document.undoStack()->setClean();
}

// What the window sees becomes the key, and is seen again there.
void MainWindowTest::theCameraInSpaceIsKeyed() {
    MainWindow* window = shown(support::testData(QStringLiteral("shapes.ifs")));
    document::Document& document = window->document();
    document.edit(QStringLiteral("solid"), pairOfCubes());
    view::SpaceNavigation& navigation = window->findChild<Stage*>()->space()->navigation();
    view::Timeline& timeline = window->findChild<view::TimelinePanel*>()->timeline();
    const auto keyAt = [&](int frame) {
        timeline.setFrame(frame);
        timeline.setRow(timeline.rowCount() - 1); // the camera
        const attractor::OrbitCamera before = navigation.camera();
        navigation.setPerspective(true);
        navigation.orbit(before, before.target, 25, 10);
        const attractor::OrbitCamera seen = navigation.camera();
        timeline.keys().set();
        return seen;
    };
    const int steps = document.undoStack()->count();
    const attractor::OrbitCamera first = keyAt(0), second = keyAt(12);
    QCOMPARE(document.undoStack()->count(), steps + 2);
    QVERIFY(first.orientation.coeffs() != second.orientation.coeffs());
    timeline.setFrame(0);
    QVERIFY(navigation.camera() == first);
    timeline.setFrame(12);
    QVERIFY(navigation.camera() == second);
    document.undoStack()->undo();
    QVERIFY(navigation.camera() == second); // the view is the user's while the playhead rests
    timeline.setFrame(6);
    QVERIFY(navigation.camera() == first);
    document.undoStack()->setClean();
}

// K, Shift+K and the keys that move the playhead, while the canvas has the focus.
void MainWindowTest::framesAreKeyedFromTheCanvas() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowActive(window));
    auto* canvas = window->findChild<view::CanvasView*>();
    canvas->setFocus();
    auto* panel = window->findChild<view::TimelinePanel*>();
    view::Timeline& timeline = panel->timeline();
    const auto framesOf = [&](std::size_t row) {
        std::vector<int> frames;
        for (const auto& key : timeline.tracks()[row].keys)
            frames.push_back(key.frame);
        return frames;
    };
    timeline.setFrame(11);
    QTest::keyClick(canvas, Qt::Key_Period);
    QCOMPARE(timeline.frame(), 12);
    QTest::keyClick(canvas, Qt::Key_K);
    QTRY_VERIFY(panel->isVisible() && panel->showsTracks());
    QCOMPARE(framesOf(0), (std::vector<int>{0, 12}));
    QVERIFY(framesOf(1).empty());
    timeline.setRow(1);
    QTest::keyClick(canvas, Qt::Key_K);
    QCOMPARE(framesOf(1), (std::vector<int>{0, 12}));
    timeline.setFrame(6);
    QTest::keyClick(canvas, Qt::Key_K, Qt::ShiftModifier);
    QCOMPARE(framesOf(0), (std::vector<int>{0, 6, 12}));
    QCOMPARE(framesOf(1), (std::vector<int>{0, 6, 12}));
    QVERIFY(framesOf(2).empty());
    QTest::keyClick(canvas, Qt::Key_Period, Qt::AltModifier);
    QCOMPARE(timeline.frame(), 12);
    QTest::keyClick(canvas, Qt::Key_Comma);
    QCOMPARE(timeline.frame(), 11);
    QTest::keyClick(canvas, Qt::Key_Comma, Qt::AltModifier);
    QCOMPARE(timeline.frame(), 6);
    for (int step = 0; step < 3; ++step)
        window->document().undoStack()->undo();
    QVERIFY(timeline.isEmpty());
    timeline.setFrame(0);
    QTest::keyClick(canvas, Qt::Key_K, Qt::ShiftModifier); // where none has keys, all get one
    for (std::size_t row = 0; row < timeline.tracks().size(); ++row)
        QCOMPARE(framesOf(row), std::vector<int>{0});
    window->document().undoStack()->setClean();
}

void MainWindowTest::spaceOnTheBallOfAxesDoesNotPlay() {
    MainWindow* window = shown(support::testData(QStringLiteral("shapes.ifs")));
    window->document().edit(QStringLiteral("solid"), pairOfCubes());
    view::Timeline& timeline = window->findChild<view::TimelinePanel*>()->timeline();
    timeline.setRow(timeline.rowCount() - 1); // the camera
    for (const int frame : {0, 12}) {
        timeline.setFrame(frame);
        timeline.keys().set();
    }
    view::SpaceView* space = window->findChild<Stage*>()->space();
    QTRY_VERIFY(space->ball().isVisible());
    space->setFocus();
    QTRY_VERIFY(space->hasFocus());
    for (int stop = 0; stop < 10 && !space->ball().focused(); ++stop)
        QTest::keyClick(space, Qt::Key_Tab);
    QVERIFY(space->ball().focused());
    const auto chosen = *space->ball().focused();
    QTest::keyClick(space, Qt::Key_Space);
    QTRY_VERIFY(view::AxisBall::looksFrom(space->navigation().camera(), chosen));
    QVERIFY(!timeline.playback().isPlaying());
    QTest::keyClick(space, Qt::Key_Escape);
    QTest::keyClick(space, Qt::Key_Space);
    QTRY_VERIFY(timeline.playback().isPlaying());
    timeline.playback().setPlaying(false);
    window->document().undoStack()->setClean();
}

// By the menu; the status bar says how far, and only of the plane.
void MainWindowTest::theViewIsRotated() {
    MainWindow* window = shown(support::testData(QStringLiteral("shapes.ifs")));
    auto* canvas = window->findChild<view::CanvasView*>();
    const auto choose = [&](const char* id) { support::command(*window, id)->trigger(); };
    const auto said = [&]() -> QString {
        for (const QLabel* label : window->statusBar()->findChildren<QLabel*>())
            if (label->accessibleName() == QStringLiteral("Rotation of the view"))
                return label->isVisible() ? label->text() : QString();
        return QStringLiteral("no label");
    };
    QVERIFY(said().isEmpty());
    choose("rotate-view-left");
    choose("rotate-view-left");
    QCOMPARE(canvas->navigation().rotation(), 30.0);
    QCOMPARE(said(), QStringLiteral("rotated 30°"));
    canvas->fit();
    choose("rotate-view-right");
    QCOMPARE(said(), QStringLiteral("rotated 15°"));
    const document::SavedView::Camera kept = window->findChild<Stage*>()->camera();
    choose("reset-rotation");
    QCOMPARE(canvas->navigation().rotation(), 0.0);
    QVERIFY(said().isEmpty());
    window->findChild<Stage*>()->lookAt(kept);
    QCOMPARE(canvas->navigation().rotation(), 15.0);
    window->document().edit(QStringLiteral("solid"), pairOfCubes());
    QVERIFY(said().isEmpty());
    window->document().undoStack()->setClean();
}

// Opened and pasted flames are turned over, and a check box lets them be as they are written.
void MainWindowTest::flamesAreReadEitherWayUp() {
    const QString flame = QStringLiteral("<flames><flame name=\"ember\"><xform weight=\"1\" linear=\"1\" "
                                         "coefs=\"0.5 0.25 -0.125 0.5 1 2\"/></flame></flames>");
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("ember.flame"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(flame.toUtf8());
    file.close();

    MainWindow* window = shown(path);
    document::Document& document = window->document();
    const auto map = [&](qsizetype entry) {
        return document::system2(*document.file().entries[entry].fractal)->maps.front().map;
    };
    const ifs::AffineMap<2> written = ifs::affineMap(0.5, -0.125, 0.25, 0.5, 1, 2);
    const ifs::AffineMap<2> turned = ifs::affineMap(0.5, 0.125, -0.25, 0.5, 1, -2);
    const auto banner = [window] { return window->findChild<FlameBanner*>(); };
    QVERIFY(banner() && banner()->isVisible());
    QVERIFY(map(0) == turned);
    banner()->findChild<QCheckBox*>()->click();
    QVERIFY(map(0) == written);
    QCOMPARE(document.undoStack()->count(), 1);
    banner()->findChild<QCheckBox*>()->click();
    QVERIFY(map(0) == turned);
    document.undoStack()->undo(); // work continues: the question is settled
    QVERIFY(map(0) == written);
    QTRY_VERIFY(!banner());

    QGuiApplication::clipboard()->setText(flame);
    window->findChild<view::EntriesPanel*>()->paste();
    QCOMPARE(document.file().entries.size(), 2);
    QVERIFY(banner() && map(1) == turned);
    banner()->findChild<QCheckBox*>()->click();
    QVERIFY(map(1) == written && map(0) == written); // the one that was there stays
    banner()->findChild<QCheckBox*>()->click();
    QVERIFY(map(1) == turned && map(0) == written);
    document.undoStack()->setClean();
}

void MainWindowTest::theMenuCopiesAsLatex() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    const auto copied = [&](const char* id) {
        QGuiApplication::clipboard()->setText(QStringLiteral("before"));
        support::command(*window, id)->trigger();
        return QTest::qWaitFor(
            [] { return QGuiApplication::clipboard()->text() != QStringLiteral("before"); }, 60'000);
    };
    QVERIFY(copied("copy-table-of-maps"));
    const QString table = QGuiApplication::clipboard()->text();
    QVERIFY(table.contains(QStringLiteral("\\begin{tabular}")));
    QCOMPARE(table.count(QStringLiteral("\\\\")), 5); // the head and four maps
    QVERIFY(copied("copy-figure-tikz"));
    QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("\\begin{tikzpicture}")));
}

void MainWindowTest::aFractalOfTheCollectionBecomesADocument() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    const qsizetype before = window->document().file().entries.size();
    QVERIFY(before > 1);
    auto* list = window->findChild<view::CollectionPanel*>()->findChild<QListView*>();
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->rowCount() > 3, 60'000);
    const QModelIndex flower = list->model()->index(2, 0);
    QCOMPARE(flower.data().toString(), QStringLiteral("Flower"));
    list->setCurrentIndex(flower);
    bool isOffered = false;
    QTimer::singleShot(0, list, [&isOffered] {
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        if (!menu) return;
        for (QAction* action : menu->actions())
            if (action->objectName() == QStringLiteral("open")) {
                isOffered = true;
                menu->setActiveAction(action);
                QTest::keyClick(menu, Qt::Key_Return);
            }
        menu->close();
    });
    emit list->customContextMenuRequested(list->visualRect(flower).center());
    QVERIFY(isOffered);
    QTRY_COMPARE(window->document().file().entries.size(), qsizetype(1));
    QCOMPARE(window->document().fractal().name, QStringLiteral("flower"));
    QCOMPARE(window->document().undoStack()->count(), 0);
    QVERIFY(window->windowFilePath().isEmpty());
}

void MainWindowTest::theMapsAreNumberedOnTheCanvas() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    auto* canvas = window->findChild<view::CanvasView*>();
    auto* numbers = support::command(*window, "numbers-of-maps");
    QVERIFY(numbers && !numbers->isChecked());
    QTRY_VERIFY(!canvas->picture().isNull());
    const auto placesOfNumbers = [&] { // the fixed points of the maps
        std::vector<QRect> places;
        for (const auto& map : document::system2(window->document().fractal())->maps) {
            const QPoint fixed = view::pixelOf(canvas->camera(), *ifs::fixedPoint(map.map)).toPoint();
            places.emplace_back(fixed - QPoint(4, 4), QSize(9, 9));
        }
        return places;
    };
    QTRY_VERIFY(std::ranges::all_of(placesOfNumbers(), [&](const QRect& place) {
        return canvas->viewport()->rect().contains(place); // once the picture is fitted
    }));
    // No event comes between them: the picture is the same in all three.
    const QImage before = canvas->viewport()->grab().toImage();
    numbers->trigger();
    const QImage with = canvas->viewport()->grab().toImage();
    numbers->trigger();
    const QImage after = canvas->viewport()->grab().toImage();
    QVERIFY(before == after);
    for (const QRect& place : placesOfNumbers())
        QVERIFY(with.copy(place) != before.copy(place));
}

BARYCAGE_TEST(MainWindowTest, QApplication);
#include "main_window_test.moc"
