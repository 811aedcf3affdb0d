// SPDX-License-Identifier: MIT
#include "cage_edits.h"
#include "canvas/canvas_view.h"
#include "dialogs/command_palette.h"
#include "dialogs/paste_table_dialog.h"
#include "dialogs/preferences_dialog.h"
#include "flame_card.h"
#include "main_window.h"
#include "panels/branch_bar.h"
#include "panels/entries_panel.h"
#include "preferences.h"
#include "recovery.h"
#include "session.h"
#include "settings.h"
#include "support/forget_settings.h"
#include "support/own_settings.h"
#include "support/paths.h"
#include "welcome.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QSet>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QTranslator>
#include <QUndoStack>

#include <algorithm>

// The window as a whole: what it opens and how it divides its room.
class MainWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanup();
    void brokenPathsShareOneWindow();
    void saysWhenWorkCannotBeKept();
    void aNarrowWindowIsHalfPicture_data();
    void aNarrowWindowIsHalfPicture();
    void preferencesReachEveryWindow();
    void theFilesOfTheLastRunAreKnown();
    void theColumnsOfATableAreAskedFor();
    void aWindowMayGoWhileANameIsTyped();
    void panelsAreWhereTheyWereLeft();
    void theWholeScreenAndBack();
    void aPresentationPutsAwayWhatIsNotCanvas();
    void aPresentationIsNotRemembered();
    void windowsHaveTheirOwnDocuments();
    void whatOthersCopiedIsPasted();
    void theHintGoesWithAnotherTool();
    void aKeyLeadsFromThePanelsToTheCanvasAndBack();
    void commandsOfThePanelsAreFound();
    void buttonsAreFoundAsCommands();
    void flamesAreReadEitherWayUp();
    void cageCommandsAreOfferedWhereTheyDoSomething();
    void namesOfPanelsAreSeenWhole_data();
    void namesOfPanelsAreSeenWhole();
    void barsFitASmallWindow_data() { namesOfPanelsAreSeenWhole_data(); }
    void barsFitASmallWindow();
    void aBarThatGoesLeavesTheFocusToTheCanvas();
    void menusHaveEveryLetterOnce();
    void whatIsDisabledSaysWhy();

private:
    static QList<MainWindow*> windows() { return session::windows(); }
    static MainWindow* shown(const QString& path) {
        auto* window = new MainWindow;
        if (!path.isEmpty()) window->openPath(path);
        window->show();
        return window;
    }
};

void MainWindowTest::initTestCase() {
    support::useOwnSettings();
    QApplication::setQuitOnLastWindowClosed(false);
}

void MainWindowTest::cleanup() {
    for (MainWindow* window : windows())
        delete window;
}

void MainWindowTest::brokenPathsShareOneWindow() {
    const QString good = support::testData(QStringLiteral("shapes.ifs"));
    MainWindow::openEach({QStringLiteral("/nowhere/a.ifs"), QStringLiteral("/nowhere/b.ifs"),
                          QStringLiteral("/nowhere/c.ifs")});
    QCOMPARE(windows().size(), 1);
    QCOMPARE(windows().first()->findChildren<QMessageBox*>().size(), 3); // each is told
    cleanup();

    MainWindow::openEach({QStringLiteral("/nowhere/a.ifs"), good, good});
    QCOMPARE(windows().size(), 2);
    for (MainWindow* window : windows())
        QVERIFY(window->windowTitle().startsWith(QStringLiteral("shapes.ifs")));
}

// A file stands where the folder for recovery should be; what was recovered is not taken away before it is
// kept.
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

void MainWindowTest::aNarrowWindowIsHalfPicture_data() {
    QTest::addColumn<int>("width");
    for (const int width : {1440, 1280, 1024})
        QTest::addRow("%d", width) << width;
}

void MainWindowTest::aNarrowWindowIsHalfPicture() {
    QFETCH(int, width);
    MainWindow window;
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    const auto* canvas = window.findChild<view::CanvasView*>();
    window.resize(width, 768);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QCOMPARE(window.width(), width);
    QVERIFY2(canvas->width() >= width * 46 / 100, qPrintable(QString::number(canvas->width())));
    window.resize(1600, 900);
    QTest::qWait(50);
    window.resize(width, 768); // the same when it is made so
    QTRY_VERIFY(canvas->width() >= width * 46 / 100);
}

void MainWindowTest::preferencesReachEveryWindow() {
    view::Preferences{{}, view::Preferences::Theme::Desktop, 50'000'000, false}.store();
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
        if (const int fine = box->findData(quint64(1'000'000'000)); fine >= 0) box->setCurrentIndex(fine);
    QCOMPARE(quality(first), std::uint64_t(1'000'000'000));
    QCOMPARE(quality(second), std::uint64_t(1'000'000'000));
    QCOMPARE(quality(shown({})), std::uint64_t(1'000'000'000));
    view::Preferences{}.store();
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
    cleanup();

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

// The field is left when the window goes, and says what it holds to a document that must still be there.
void MainWindowTest::aWindowMayGoWhileANameIsTyped() {
    MainWindow* window = shown(support::testData(QStringLiteral("shapes.ifs")));
    QVERIFY(QTest::qWaitForWindowActive(window));
    auto* list = window->findChild<QDockWidget*>(QStringLiteral("entries"))->findChild<QListView*>();
    QVERIFY(list);
    list->setFocus();
    list->edit(list->currentIndex());
    auto* field = list->findChild<QLineEdit*>();
    QVERIFY(field && field->isVisible());
    field->setText(QStringLiteral("renamed"));
    QStringList names;
    connect(&window->document(), &document::Document::changed, this,
            [&] { names << window->document().fractal().name; });
    delete window;
    QCOMPARE(names, QStringList{QStringLiteral("renamed")});
}

// One is closed, one floats, one is in front of those that share its place, and one is on the other side.
void MainWindowTest::panelsAreWhereTheyWereLeft() {
    support::forgetSettings();
    const auto panel = [](MainWindow* window, const char* id) {
        return window->findChild<QDockWidget*>(QLatin1String(id));
    };
    MainWindow* first = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(first));
    first->resize(1200, 700);
    QVERIFY(panel(first, "collection")->isVisible() && !panel(first, "maps")->isFloating());
    panel(first, "collection")->close();
    panel(first, "history")->setFloating(true);
    first->addDockWidget(Qt::LeftDockWidgetArea, panel(first, "analysis"));
    panel(first, "appearance")->raise();
    first->resizeDocks({panel(first, "maps")}, {390}, Qt::Horizontal);
    const auto* names =
        panel(first, "appearance")->parentWidget()->findChild<QTabBar*>({}, Qt::FindDirectChildrenOnly);
    QTRY_COMPARE(panel(first, "appearance")->width(), 390 - names->width());
    const int width = panel(first, "appearance")->width();
    first->close();
    QTRY_VERIFY(windows().isEmpty());

    MainWindow* second = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(second));
    QCOMPARE(second->size(), QSize(1200, 700));
    QVERIFY(!panel(second, "collection")->isVisible());
    QVERIFY(panel(second, "history")->isFloating() && panel(second, "history")->isVisible());
    QCOMPARE(second->dockWidgetArea(panel(second, "analysis")), Qt::LeftDockWidgetArea);
    QTRY_VERIFY(!panel(second, "appearance")->visibleRegion().isEmpty());
    QVERIFY(panel(second, "maps")->visibleRegion().isEmpty()); // behind it
    QTRY_COMPARE(panel(second, "appearance")->width(), width);
    support::forgetSettings();
}

void MainWindowTest::theWholeScreenAndBack() {
    support::forgetSettings();
    MainWindow* window = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->resize(900, 600);
    QAction* full = nullptr;
    for (auto* action : window->findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(Qt::Key_F11)) full = action;
    QVERIFY(full);
    QTest::keyClick(window, Qt::Key_F11);
    QTRY_VERIFY(window->isFullScreen() && full->isChecked());
    QTRY_COMPARE(window->size(), window->screen()->size());
    QVERIFY(window->menuBar()->isVisible() && !window->menuBar()->visibleRegion().isEmpty());
    QTest::keyClick(window, Qt::Key_F11);
    QTRY_VERIFY(!window->isFullScreen() && !full->isChecked());
    QTRY_COMPARE(window->size(), QSize(900, 600));

    window->showFullScreen(); // by the desktop
    QTRY_VERIFY(full->isChecked());
    window->close(); // so left, so found
    QTRY_VERIFY(windows().isEmpty());
    MainWindow* next = shown({});
    QTRY_VERIFY(next->isFullScreen());
    for (auto* action : next->findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(Qt::Key_F11)) action->trigger();
    QTRY_VERIFY(!next->isFullScreen());
    support::forgetSettings();
}

void MainWindowTest::aPresentationPutsAwayWhatIsNotCanvas() {
    support::forgetSettings();
    MainWindow* window = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->openFirstPicture();
    window->resize(1000, 700);
    auto* canvas = window->findChild<view::CanvasView*>();
    auto* analysis = window->findChild<QDockWidget*>(QStringLiteral("analysis"));
    analysis->raise();
    QTRY_VERIFY(!analysis->visibleRegion().isEmpty());
    const QSize before = canvas->size();
    document::Fractal edited = window->document().fractal();
    edited.name = QStringLiteral("mine");
    window->document().edit(QStringLiteral("rename"), edited);

    QTest::keyClick(window, Qt::Key_F11, Qt::ShiftModifier);
    QTRY_VERIFY(window->isFullScreen());
    QTRY_COMPARE(canvas->size(), window->screen()->size());  // nothing else has room
    QTest::keyClick(canvas, Qt::Key_Z, Qt::ControlModifier); // commands are in force all the same
    QCOMPARE(window->document().fractal().name, QStringLiteral("maple"));
    QTest::keyClick(canvas, Qt::Key_W);
    auto* arising = window->findChild<QToolBar*>(QStringLiteral("arising"));
    QTRY_VERIFY(arising->isVisible()); // what is shown by it belongs to the picture
    QTest::keyClick(canvas, Qt::Key_Escape);
    QTRY_VERIFY(!window->isFullScreen());
    QTRY_COMPARE(window->size(), QSize(1000, 700));
    QVERIFY(window->menuBar()->isVisible() && window->statusBar()->isVisible() && arising->isVisible());
    QTRY_VERIFY(!analysis->visibleRegion().isEmpty());
    QTest::keyClick(canvas, Qt::Key_W);
    QTRY_COMPARE(canvas->size(), before);
    window->document().undoStack()->setClean();
}

void MainWindowTest::aPresentationIsNotRemembered() {
    support::forgetSettings();
    MainWindow* window = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->resize(1000, 700);
    QTest::keyClick(window, Qt::Key_F11, Qt::ShiftModifier);
    QTRY_VERIFY(window->isFullScreen());
    window->close();
    QTRY_VERIFY(windows().isEmpty());
    MainWindow* next = shown({});
    QTRY_COMPARE(next->size(), QSize(1000, 700));
    QVERIFY(!next->isFullScreen() && next->menuBar()->isVisible());
    QVERIFY(!next->findChild<QDockWidget*>(QStringLiteral("maps"))->isHidden());
    support::forgetSettings();
}

void MainWindowTest::windowsHaveTheirOwnDocuments() {
    MainWindow* first = shown(support::testData(QStringLiteral("shapes.ifs")));
    QVERIFY(QTest::qWaitForWindowActive(first));
    QTest::keyClick(first, Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(windows().size(), 2);
    MainWindow* second = windows()[windows().first() == first ? 1 : 0];
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
    support::forgetSettings();
    for (const bool byTool : {true, false}) {
        auto* window = new MainWindow;
        window->openFirstPicture();
        window->show();
        QVERIFY(QTest::qWaitForWindowExposed(window));
        auto* canvas = window->findChild<view::CanvasView*>();
        QCOMPARE(!canvas->hint().isEmpty(), byTool); // not a second time
        if (byTool) canvas->setTool(view::CanvasView::Tool::Maps);
        QVERIFY(canvas->hint().isEmpty());
        canvas->setTool(view::CanvasView::Tool::Cage);
        QVERIFY(canvas->hint().isEmpty());
        delete window;
    }
}

void MainWindowTest::aKeyLeadsFromThePanelsToTheCanvasAndBack() {
    MainWindow* window = shown(support::testData(QStringLiteral("shapes.ifs")));
    QVERIFY(QTest::qWaitForWindowActive(window));
    const auto* canvas = window->findChild<view::CanvasView*>();
    auto* maps = window->findChild<QDockWidget*>(QStringLiteral("maps"))->findChild<QTableView*>();
    auto* entries = window->findChild<QDockWidget*>(QStringLiteral("entries"))->findChild<QListView*>();
    for (QWidget* part : std::initializer_list<QWidget*>{maps, entries}) {
        part->setFocus();
        QTRY_VERIFY(part->hasFocus());
        QTest::keyClick(part, Qt::Key_F6);
        QVERIFY(canvas->hasFocus());
        QTest::keyClick(window->focusWidget(), Qt::Key_F6);
        QVERIFY(!canvas->hasFocus());
    }
}

void MainWindowTest::commandsOfThePanelsAreFound() {
    MainWindow* window = shown({});
    QHash<QString, QAction*> found;
    for (const view::NamedAction& action : view::actionsOf(*window)) {
        QVERIFY2(!found.contains(action.path), qPrintable(action.path));
        found.insert(action.path, action.action);
    }
    const std::pair<const char*, QKeySequence> wanted[] = {
        {"Maps › Add", QKeySequence(QStringLiteral("Ctrl+Ins"))},
        {"Maps › Duplicate", QKeySequence(Qt::Key_Insert)},
        {"Maps › Delete", QKeySequence(Qt::Key_Delete)},
        {"Maps › Move Up", QKeySequence(QStringLiteral("Alt+Up"))},
        {"Maps › Copy Rows", QKeySequence(QKeySequence::Copy)},
        {"Maps › Weights › By |Determinant|", {}},
        {"Maps › Weights › Normalise", {}},
        {"Entries › Add Entry", {}},
        {"Entries › Duplicate", QKeySequence(Qt::Key_Insert)},
        {"Entries › Rename", QKeySequence(Qt::Key_F2)},
        {"Entries › Move Down", QKeySequence(QStringLiteral("Alt+Down"))},
        {"Collection › Favourite", QKeySequence(QStringLiteral("Ctrl+D"))},
        {"Collection › Add to This File", QKeySequence(QStringLiteral("Shift+Return"))},
        {"Edit › Undo", QKeySequence(QStringLiteral("Ctrl+Z"))},
    };
    for (const auto& [path, keys] : wanted) {
        QAction* action = found.value(QString::fromUtf8(path));
        QVERIFY2(action, path);
        QCOMPARE(action->shortcut(), keys);
    }
    // A key that two commands have is the window's in at most one of them.
    QSet<QKeySequence> ofTheWindow;
    for (const QAction* action : std::as_const(found))
        for (const QKeySequence& keys : action->shortcuts()) {
            if (action->shortcutContext() != Qt::WindowShortcut) continue;
            QVERIFY2(!ofTheWindow.contains(keys), qPrintable(keys.toString()));
            ofTheWindow.insert(keys);
        }
    // A step in the history does not change what the command is called.
    auto* add = found.value(QStringLiteral("Maps › Add"));
    add->trigger();
    QVERIFY(found.value(QStringLiteral("Edit › Undo"))->text() != QStringLiteral("&Undo"));
    bool named = false;
    for (const view::NamedAction& action : view::actionsOf(*window))
        named = named || action.path == QStringLiteral("Edit › Undo");
    QVERIFY(named);
}

void MainWindowTest::buttonsAreFoundAsCommands() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    const auto command = [window](const char* path) -> QAction* {
        for (const view::NamedAction& action : view::actionsOf(*window))
            if (action.path == QString::fromUtf8(path)) return action.action;
        return nullptr;
    };
    for (const char* path : {"Cage › Show the rest cage", "Analysis › On the canvas › Hull",
                             "Analysis › On the canvas › Cylinders", "Appearance › Reset to Default",
                             "Appearance › Edit Palette", "Maps › Show columns: Effective code",
                             "How It Arises › Steps Wⁿ", "How It Arises › Chaos Game"})
        QVERIFY2(command(path), path);
    // Those of what is not unfolded come with it.
    const char* reverse = "Appearance › Palette editor › Reverse";
    QVERIFY(!command(reverse));
    command("Appearance › Edit Palette")->trigger();
    const attractor::Palette before = window->document().fractal().appearance.palette;
    QVERIFY(command(reverse));
    command(reverse)->trigger();
    QVERIFY(!(window->document().fractal().appearance.palette == before));
    // A button that can do nothing does nothing as a command.
    QVERIFY(command("Appearance › Reset to Default")->isEnabled());
    command("Appearance › Reset to Default")->trigger();
    QVERIFY(!command("Appearance › Reset to Default")->isEnabled());

    // Where the button is, is shown.
    const auto* bar = window->findChild<QToolBar*>(QStringLiteral("arising"));
    QVERIFY(bar->isHidden() && !command("How It Arises › Start"));
    view::CommandPalette palette(view::actionsOf(*window));
    palette.show();
    QTest::keyClicks(palette.findChild<QLineEdit*>(), QStringLiteral("arises chaos"));
    QTest::keyClick(palette.findChild<QLineEdit*>(), Qt::Key_Return);
    QVERIFY(bar->isVisible());
    QVERIFY(command("How It Arises › Start"));
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
    const auto card = [window] { return window->findChild<FlameCard*>(); };
    QVERIFY(card() && card()->isVisible());
    QVERIFY(map(0) == turned);
    card()->findChild<QCheckBox*>()->click();
    QVERIFY(map(0) == written);
    QCOMPARE(document.undoStack()->count(), 1);
    card()->findChild<QCheckBox*>()->click();
    QVERIFY(map(0) == turned);
    document.undoStack()->undo(); // somebody goes on: the question is settled
    QVERIFY(map(0) == written);
    QTRY_VERIFY(!card());

    QGuiApplication::clipboard()->setText(flame);
    window->findChild<view::EntriesPanel*>()->paste();
    QCOMPARE(document.file().entries.size(), 2);
    QVERIFY(card() && map(1) == turned);
    card()->findChild<QCheckBox*>()->click();
    QVERIFY(map(1) == written && map(0) == written); // the one that was there stays
    card()->findChild<QCheckBox*>()->click();
    QVERIFY(map(1) == turned && map(0) == written);
    document.undoStack()->setClean();
}

void MainWindowTest::cageCommandsAreOfferedWhereTheyDoSomething() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    document::Document& document = window->document();
    const auto offered = [window](const char* name) {
        for (const view::NamedAction& action : view::actionsOf(window->menuWidget()))
            if (action.path == QString::fromUtf8(name)) return action.action->isEnabled();
        return false;
    };
    const auto offers = [&](bool reset, bool bake, bool unbake) {
        return offered("Cage › Reset") == reset && offered("Cage › Bake") == bake &&
               offered("Cage › Unbake") == unbake;
    };
    const QList<const char*> ofThePlane{"File › Export Picture", "File › Copy Picture",
                                        "File › Print",          "Edit › Transform",
                                        "Edit › Mutate",         "Cage › Fit Minimal Canonical Simplex",
                                        "Cage › Make Regular",   "Cage › Affine Invariant Form"};
    QVERIFY(std::all_of(ofThePlane.begin(), ofThePlane.end(), offered));
    QVERIFY(offers(false, false, true)); // at rest
    document::Fractal fractal = document.fractal();
    fractal.cage = document::effectiveCage(fractal);
    fractal.cage->current[0] += ifs::Vector<2>(1, 1);
    document.edit(QStringLiteral("place"), fractal);
    QVERIFY(offers(true, true, false));
    fractal.cage->current[0] = fractal.cage->current[1]; // flat: it can be opened, and nothing else
    document.edit(QStringLiteral("flatten"), fractal);
    QVERIFY(offers(true, false, false));
    document.undoStack()->undo();
    QVERIFY(offers(true, true, false));
    document.undoStack()->undo();
    QVERIFY(offers(false, false, true));
    document::Fractal space;
    space.system = document::System3{};
    document.edit(QStringLiteral("space"), space);
    QVERIFY(offers(false, false, false));
    QVERIFY(std::none_of(ofThePlane.begin(), ofThePlane.end(), offered));
    QVERIFY(!offered("File › Revert")); // it has no file
    document.undoStack()->setClean();
}

void MainWindowTest::namesOfPanelsAreSeenWhole_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "de", "es", "fr", "mk"})
        QTest::newRow(language) << QString::fromLatin1(language);
}

void MainWindowTest::namesOfPanelsAreSeenWhole() {
    QFETCH(QString, language);
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(":/translations/barycage_%1.qm").arg(language)));
    QVERIFY(QCoreApplication::installTranslator(&translator));
    MainWindow* window = shown({});
    window->resize(1024, 768);
    QVERIFY(QTest::qWaitForWindowExposed(window));
    int names = 0;
    for (const auto* bar : window->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        for (int i = 0; i < bar->count(); ++i, ++names) {
            const QSize room = bar->tabRect(i).size();
            const int needed = bar->fontMetrics().horizontalAdvance(bar->tabText(i));
            QVERIFY2(std::max(room.width(), room.height()) > needed, qPrintable(bar->tabText(i)));
            QVERIFY(bar->rect().contains(bar->tabRect(i)));
        }
    QCOMPARE(names, 5);
    const int half = window->findChild<view::CanvasView*>()->width() * 100 / 46;
    QVERIFY2(half >= window->width(), "the panels are too wide in this language");
}

// Both under the canvas, and with branches to put back; also where the layout of an earlier version, which
// had them side by side, comes back.
void MainWindowTest::barsFitASmallWindow() {
    QFETCH(QString, language);
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(":/translations/barycage_%1.qm").arg(language)));
    QVERIFY(QCoreApplication::installTranslator(&translator));
    QSettings().clear();
    for (int run = 0; run < 2; ++run) {
        MainWindow* window = shown({});
        window->openFirstPicture();
        QVERIFY(QTest::qWaitForWindowExposed(window));
        window->resize(800, 600);
        document::Fractal fractal = window->document().fractal();
        const ifs::MapId first = document::system2(fractal)->maps.front().id;
        fractal.moved.push_back({{first, first}, ifs::affineMap(1, 0, 0, 1, 0.1, 0)});
        window->document().edit(QStringLiteral("move"), fractal);
        window->findChild<view::CanvasView*>()->setTool(view::CanvasView::Tool::Branch);
        auto* arising = window->findChild<QToolBar*>(QStringLiteral("arising"));
        auto* branches = window->findChild<QToolBar*>(QStringLiteral("branches"));
        arising->show();
        QTRY_VERIFY(branches->isVisible() && branches->y() != arising->y());
        QCOMPARE(window->width(), 800);
        for (const QToolBar* bar : {arising, branches})
            QVERIFY(bar->minimumSizeHint().width() < 700); // letters are larger elsewhere
        window->removeToolBarBreak(branches);
        window->document().undoStack()->setClean();
        window->close();
        QTRY_VERIFY(windows().isEmpty());
    }
    QSettings().clear();
}

void MainWindowTest::aBarThatGoesLeavesTheFocusToTheCanvas() {
    QSettings().clear();
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowActive(window));
    auto* canvas = window->findChild<view::CanvasView*>();
    auto* arising = window->findChild<QToolBar*>(QStringLiteral("arising"));
    arising->toggleViewAction()->trigger();
    for (auto* button : arising->findChildren<QAbstractButton*>())
        if (button->isCheckable() && button->isVisible()) button->setFocus();
    QVERIFY(arising->isAncestorOf(QApplication::focusWidget()));
    arising->toggleViewAction()->trigger();
    QVERIFY(canvas->hasFocus());

    using Tool = view::CanvasView::Tool;
    const auto* bar = window->findChild<view::BranchBar*>();
    for (const Tool next : {Tool::Maps, Tool::Cage}) {
        canvas->setTool(Tool::Branch);
        bar->edit()->setFocus();
        QVERIFY(bar->edit()->hasFocus());
        canvas->setTool(next);
        QVERIFY(canvas->hasFocus());
    }
}

// Those of the bar are not taken by what stands beside the canvas, either.
void MainWindowTest::menusHaveEveryLetterOnce() {
    MainWindow* window = shown({});
    const auto letter = [](const QString& text) { return QKeySequence::mnemonic(text).toString(); };
    QList<const QWidget*> menus{window->menuBar()};
    QSet<QString> ofTheBar;
    for (const QAction* action : window->menuBar()->actions()) {
        menus << action->menu();
        ofTheBar << letter(action->text());
    }
    for (const QWidget* menu : menus) {
        QSet<QString> taken;
        for (const QAction* action : menu->actions()) {
            const QString key = letter(action->text());
            QVERIFY2(key.isEmpty() || !taken.contains(key), qPrintable(action->text()));
            taken << key;
        }
    }
    Welcome::offer(window);
    for (const QWidget* part : {static_cast<const QWidget*>(window->findChild<Welcome*>()),
                                static_cast<const QWidget*>(window->findChild<view::BranchBar*>())}) {
        for (const auto* button : part->findChildren<QAbstractButton*>())
            QVERIFY2(!ofTheBar.contains(letter(button->text())), qPrintable(button->text()));
        for (const auto* label : part->findChildren<QLabel*>())
            QVERIFY2(!ofTheBar.contains(letter(label->text())), qPrintable(label->text()));
    }
}

void MainWindowTest::whatIsDisabledSaysWhy() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowActive(window));
    QAction* bake = nullptr;
    for (auto* action : window->findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+B"))) bake = action;
    QVERIFY(bake && !bake->isEnabled());
    const QString why = view::bakeObstacle(window->document().fractal());
    QVERIFY(!why.isEmpty());
    QCOMPARE(bake->statusTip(), why);
    QCOMPARE(bake->toolTip(), why);
    for (const QAction* menu : window->menuBar()->actions())
        QVERIFY(menu->menu()->toolTipsVisible());
    QTest::keyClick(window->findChild<view::CanvasView*>(), Qt::Key_B, Qt::ControlModifier);
    QCOMPARE(window->statusBar()->currentMessage(), why);
    // Once it can be done the key does it.
    document::Fractal fractal = window->document().fractal();
    fractal.cage = document::effectiveCage(fractal);
    fractal.cage->current[0] += ifs::Vector<2>(1, 1);
    window->document().edit(QStringLiteral("place"), fractal);
    QVERIFY(bake->isEnabled() && bake->statusTip() != why);
    QTest::keyClick(window->findChild<view::CanvasView*>(), Qt::Key_B, Qt::ControlModifier);
    QCOMPARE(window->document().undoStack()->count(), 2);
    window->document().undoStack()->setClean();
}

QTEST_MAIN(MainWindowTest)
#include "main_window_test.moc"
