// SPDX-License-Identifier: MIT
#include "bars/branch_bar.h"
#include "bars/tool_options_bar.h"
#include "canvas/canvas_view.h"
#include "ifs/cage/hull_cage.h"
#include "io/collection_reader.h"
#include "panels/appearance/appearance_panel.h"
#include "panels/appearance/controls/appearance_slider.h"
#include "panels/appearance/slice_rows.h"
#include "panels/cage/cage_panel.h"
#include "panels/timeline/motion_page.h"
#include "session_fixture.h"
#include "support/choose.h"
#include "support/forget_settings.h"
#include "support/languages.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"
#include "widgets/numbers/number_field.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QMenuBar>
#include <QPushButton>
#include <QScopeGuard>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QToolBar>

#include <algorithm>
#include <array>
#include <cmath>

// How the window divides its room, and what of it is kept.
class WindowLayoutTest : public SessionFixture {
    Q_OBJECT

private slots:
    void aNarrowWindowIsHalfPicture_data();
    void aNarrowWindowIsHalfPicture();
    void aSmallWindowIsHalfPicture();
    void panelsTakeTheirWidthsBack();
    void panelsTakeHalfOfTheWindowBack();
    void panelsAreWhereTheyWereLeft();
    void aBarIsFoundUnderItsFormerName();
    void theWholeScreenAndBack();
    void aPresentationPutsAwayWhatIsNotCanvas();
    void aPresentationIsNotRemembered();
    void barsFitASmallWindow_data();
    void barsFitASmallWindow();
    void largeLettersFitASmallScreen_data() { barsFitASmallWindow_data(); }
    void largeLettersFitASmallScreen();
    void detailsOfMapsScrollWhereTheyHaveNoRoom();
    void aBarThatGoesLeavesTheFocusToTheCanvas();
    void thePictureStaysWhateverTheTool();
    void aCageOfManyCornersIsScrolled();
    void aSolidFitsASmallWindow_data();
    void aSolidFitsASmallWindow();
    void rowsOfASliceAppear_data();
    void rowsOfASliceAppear();
    void hintsInSpaceAreThoseOfTheTool();
    void theTimelineIsSeenWhole_data() { barsFitASmallWindow_data(); }
    void theTimelineIsSeenWhole();
    void theTimelineIsRemembered();
};

void WindowLayoutTest::aNarrowWindowIsHalfPicture_data() {
    QTest::addColumn<int>("width");
    for (const int width : {1440, 1280, 1024})
        QTest::addRow("%d", width) << width;
}

void WindowLayoutTest::aNarrowWindowIsHalfPicture() {
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
    support::handleEvents();
    window.resize(width, 768); // the same when it is made so
    QTRY_VERIFY(canvas->width() >= width * 46 / 100);
}

// 800 by 600 pixels: the panels on the left make way, come back with the room, and are there when asked for.
void WindowLayoutTest::aSmallWindowIsHalfPicture() {
    support::forgetSettings();
    MainWindow* window = shown({});
    const auto* canvas = window->findChild<view::CanvasView*>();
    auto* entries = window->findChild<QDockWidget*>(QStringLiteral("entries"));
    entries->show();
    window->resize(1200, 780);
    QVERIFY(QTest::qWaitForWindowExposed(window));
    QTRY_VERIFY(entries->isVisible());
    window->resize(800, 600);
    QTRY_COMPARE(window->size(), QSize(800, 600));
    QTRY_VERIFY2(canvas->width() >= 400, qPrintable(QString::number(canvas->width())));
    QVERIFY(!entries->isVisible());
    QVERIFY(window->statusBar()->currentMessage().contains(entries->windowTitle())); // not silently
    entries->toggleViewAction()->trigger();
    QTRY_VERIFY(entries->isVisible());
    window->resize(1200, 780);
    for (const char* id : {"entries", "collection"})
        QTRY_VERIFY(window->findChild<QDockWidget*>(QLatin1String(id))->isVisible());
    window->resize(800, 600);
    QTRY_VERIFY(!entries->isVisible());
    window->close();
    QTRY_VERIFY(windows().isEmpty());

    MainWindow* next = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(next));
    QCOMPARE(next->size(), QSize(800, 600));
    QTRY_VERIFY(next->findChild<view::CanvasView*>()->width() >= 400);
    next->resize(1200, 780); // what made way in the last run is not lost
    QTRY_VERIFY(next->findChild<QDockWidget*>(QStringLiteral("entries"))->isVisible());
    support::forgetSettings();
}

void WindowLayoutTest::panelsTakeTheirWidthsBack() {
    support::forgetSettings();
    MainWindow* window = shown({});
    auto* entries = window->findChild<QDockWidget*>(QStringLiteral("entries"));
    entries->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->resize(1600, 900);
    window->resizeDocks({entries}, {310}, Qt::Horizontal);
    QTRY_VERIFY(std::abs(entries->width() - 310) <= 30);
    const int before = entries->width();
    window->resize(1000, 800); // in two steps: the panels yield, then they hide
    QTRY_VERIFY(entries->width() < before);
    window->resize(800, 600);
    QTRY_VERIFY(!entries->isVisible());
    window->resize(1600, 900);
    QTRY_VERIFY(entries->isVisible());
    QTRY_VERIFY2(std::abs(entries->width() - before) <= 1, qPrintable(QString::number(entries->width())));
    window->resize(1000, 800);
    QTRY_VERIFY(entries->width() < before);
    window->resize(1600, 900);
    QTRY_VERIFY2(std::abs(entries->width() - before) <= 1, qPrintable(QString::number(entries->width())));
    support::forgetSettings();
}

void WindowLayoutTest::panelsTakeHalfOfTheWindowBack() {
    support::forgetSettings();
    MainWindow* window = shown({});
    auto* maps = window->findChild<QDockWidget*>(QStringLiteral("maps"));
    window->resize(1600, 900);
    window->resizeDocks({maps}, {560}, Qt::Horizontal);
    QTRY_VERIFY(maps->width() > 520);
    window->resize(1280, 800);
    QTRY_VERIFY(maps->width() < 500);
    const int before = maps->width();
    window->resize(900, 800);
    QTRY_VERIFY(maps->width() < before - 20);
    window->resize(1280, 800);
    QTRY_VERIFY2(std::abs(maps->width() - before) <= 4, qPrintable(QString::number(maps->width())));
}

// One is closed, one floats, one is in front of those that share its place, and one is on the other side.
void WindowLayoutTest::panelsAreWhereTheyWereLeft() {
    support::forgetSettings();
    const auto panel = [](MainWindow* window, const char* id) {
        return window->findChild<QDockWidget*>(QLatin1String(id));
    };
    MainWindow* first = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(first));
    first->resize(1200, 700);
    QVERIFY(panel(first, "collection")->isVisible() && !panel(first, "maps")->isFloating());
    panel(first, "collection")->close();
    for (const char* id : {"history", "analysis"})
        panel(first, id)->show();
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

void WindowLayoutTest::aBarIsFoundUnderItsFormerName() {
    support::forgetSettings();
    MainWindow* first = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(first));
    auto* bar = first->findChild<QToolBar*>(QStringLiteral("construction"));
    bar->show();
    QTRY_VERIFY(bar->isVisible());
    bar->setObjectName(QStringLiteral("arising")); // as earlier versions stored it
    first->close();
    QTRY_VERIFY(windows().isEmpty());

    MainWindow* second = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(second));
    bar = second->findChild<QToolBar*>(QStringLiteral("construction"));
    QVERIFY(bar);
    QTRY_VERIFY(bar->isVisible());
    support::forgetSettings();
}

void WindowLayoutTest::theWholeScreenAndBack() {
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

void WindowLayoutTest::aPresentationPutsAwayWhatIsNotCanvas() {
    support::forgetSettings();
    MainWindow* window = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->openFirstPicture();
    window->resize(1000, 700);
    auto* canvas = window->findChild<view::CanvasView*>();
    auto* analysis = window->findChild<QDockWidget*>(QStringLiteral("analysis"));
    analysis->show();
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
    auto* construction = window->findChild<QToolBar*>(QStringLiteral("construction"));
    QTRY_VERIFY(construction->isVisible()); // what is shown by it belongs to the picture
    QTest::keyClick(canvas, Qt::Key_Escape);
    QTRY_VERIFY(!window->isFullScreen());
    QTRY_COMPARE(window->size(), QSize(1000, 700));
    QVERIFY(window->menuBar()->isVisible() && window->statusBar()->isVisible() && construction->isVisible());
    QTRY_VERIFY(!analysis->visibleRegion().isEmpty());
    QTest::keyClick(canvas, Qt::Key_W);
    QTRY_COMPARE(canvas->size(), before);
    window->document().undoStack()->setClean();
}

void WindowLayoutTest::aPresentationIsNotRemembered() {
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

void WindowLayoutTest::barsFitASmallWindow_data() {
    support::addLanguages();
}

// Both under the canvas, and with branches to put back; also where the layout of an earlier version, which
// had them side by side, comes back.
void WindowLayoutTest::barsFitASmallWindow() {
    QFETCH(QString, language);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    QSettings().clear();
    for (int run = 0; run < 2; ++run) {
        MainWindow* window = shown({});
        window->openFirstPicture();
        QVERIFY(QTest::qWaitForWindowExposed(window));
        window->resize(800, 600);
        document::Fractal fractal = window->document().fractal();
        const ifs::MapId first = document::system2(fractal)->maps.front().id;
        document::plane(fractal)->moved.push_back({{first, first}, ifs::affineMap(1, 0, 0, 1, 0.1, 0)});
        window->document().edit(QStringLiteral("move"), fractal);
        window->findChild<view::CanvasView*>()->setTool(view::CanvasView::Tool::Branch);
        auto* construction = window->findChild<QToolBar*>(QStringLiteral("construction"));
        auto* branches = window->findChild<QToolBar*>(QStringLiteral("tool-options"));
        construction->show();
        QTRY_VERIFY(branches->isVisible() && branches->y() != construction->y());
        QCOMPARE(window->width(), 800);
        for (const QToolBar* bar : {construction, branches})
            QVERIFY2(bar->minimumSizeHint().width() < 700, // letters are larger elsewhere
                     qPrintable(bar->objectName() + u' ' + QString::number(bar->minimumSizeHint().width())));
        window->removeToolBarBreak(branches);
        window->document().undoStack()->setClean();
        window->close();
        QTRY_VERIFY(windows().isEmpty());
    }
    QSettings().clear();
}

// Letters of 175 % on a screen of 1366 by 768 pixels, of which the title of the window takes some.
void WindowLayoutTest::largeLettersFitASmallScreen() {
    QFETCH(QString, language);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    const QFont usual = QApplication::font();
    QFont large = usual;
    large.setPointSizeF(1.75 * usual.pointSizeF());
    QApplication::setFont(large);
    const auto back = qScopeGuard([&] { QApplication::setFont(usual); });
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    const QSize needed = window->minimumSizeHint();
    QVERIFY2(needed.width() <= 1366 && needed.height() <= 728,
             qPrintable(QStringLiteral("%1 x %2").arg(needed.width()).arg(needed.height())));
    closeWindows();
}

void WindowLayoutTest::detailsOfMapsScrollWhereTheyHaveNoRoom() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    window->resize(1200, 900);
    QVERIFY(QTest::qWaitForWindowExposed(window));
    auto* dock = window->findChild<QDockWidget*>(QStringLiteral("maps"));
    const auto* area = dock->findChild<QScrollArea*>(QStringLiteral("details"));
    QTRY_VERIFY(!area->verticalScrollBar()->isVisible());
    QCOMPARE(area->height(), area->widget()->sizeHint().height());
    dock->setFloating(true);
    dock->resize(dock->width(), dock->minimumSizeHint().height());
    QTRY_VERIFY(area->verticalScrollBar()->isVisible());
    QVERIFY(area->height() < area->widget()->height());
    dock->setFloating(false);
}

void WindowLayoutTest::aBarThatGoesLeavesTheFocusToTheCanvas() {
    QSettings().clear();
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowActive(window));
    auto* canvas = window->findChild<view::CanvasView*>();
    auto* construction = window->findChild<QToolBar*>(QStringLiteral("construction"));
    construction->toggleViewAction()->trigger();
    for (auto* button : construction->findChildren<QAbstractButton*>())
        if (button->isCheckable() && button->isVisible()) button->setFocus();
    QTRY_VERIFY(construction->isAncestorOf(QApplication::focusWidget()));
    construction->toggleViewAction()->trigger();
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

// The options of a tool are in a bar that keeps its place and height.
void WindowLayoutTest::thePictureStaysWhateverTheTool() {
    using Tool = view::CanvasView::Tool;
    QSettings().clear();
    for (const QSize& size : {QSize(1024, 768), QSize(1440, 900)}) {
        MainWindow* window = shown({});
        window->openFirstPicture();
        window->resize(size);
        QVERIFY(QTest::qWaitForWindowExposed(window));
        auto* canvas = window->findChild<view::CanvasView*>();
        const auto* bar = window->findChild<QToolBar*>(QStringLiteral("tool-options"));
        const auto* options = window->findChild<view::ToolOptionsBar*>();
        QVERIFY(bar && bar->isVisible() && options);
        QTRY_COMPARE(window->size(), size);
        const QRect place = canvas->geometry(), barPlace = bar->geometry();
        const attractor::Camera camera = canvas->camera();
        for (const Tool tool : {Tool::Maps, Tool::Branch, Tool::DefineTriangle, Tool::Cage}) {
            canvas->setTool(tool);
            support::handleEvents();
            QCOMPARE(canvas->geometry(), place);
            QCOMPARE(bar->geometry(), barPlace);
            QVERIFY(canvas->camera() == camera);
            const bool hasOptions = tool == Tool::Maps || tool == Tool::Branch;
            QCOMPARE(options->hint().isEmpty(), hasOptions);
        }
        // Also where a branch can be put back, which adds a button.
        canvas->setTool(Tool::Branch);
        document::Fractal fractal = window->document().fractal();
        const ifs::MapId first = document::system2(fractal)->maps.front().id;
        document::plane(fractal)->moved.push_back({{first, first}, ifs::affineMap(1, 0, 0, 1, 0.1, 0)});
        window->document().edit(QStringLiteral("move"), fractal);
        support::handleEvents();
        QCOMPARE(canvas->geometry(), place);
        window->document().undoStack()->setClean();
        window->close();
        QTRY_VERIFY(windows().isEmpty());
    }
    QSettings().clear();
}

void WindowLayoutTest::aSolidFitsASmallWindow_data() {
    QTest::addColumn<bool>("isShown");
    QTest::newRow("opened at the start") << false;
    QTest::newRow("opened later") << true;
}

// The panels give way, not the screen.
void WindowLayoutTest::aSolidFitsASmallWindow() {
    QFETCH(bool, isShown);
    QSettings().clear();
    constexpr int height = 570; // on a screen of 600
    MainWindow window;
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.resize(970, height);
    if (isShown) window.show();
    QFile plants(support::sourcePath(QStringLiteral("ifs_library/space_plants.ifs")));
    QVERIFY(plants.open(QIODevice::ReadOnly));
    window.document().setFile(io::readCollection(plants.readAll()).file);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QCOMPARE(document::dimension(window.document().fractal()), 3);
    for (const char* name : {"cage", "appearance", "analysis", "history", "maps"}) {
        window.findChild<QDockWidget*>(QLatin1String(name))->show();
        window.findChild<QDockWidget*>(QLatin1String(name))->raise();
        support::handleEvents();
        QCOMPARE(window.height(), height);
    }
}

void WindowLayoutTest::hintsInSpaceAreThoseOfTheTool() {
    using Tool = view::CanvasView::Tool;
    MainWindow window;
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    QFile plants(support::sourcePath(QStringLiteral("ifs_library/space_plants.ifs")));
    QVERIFY(plants.open(QIODevice::ReadOnly));
    window.document().setFile(io::readCollection(plants.readAll()).file);
    auto* canvas = window.findChild<view::CanvasView*>();
    const auto* options = window.findChild<view::ToolOptionsBar*>();
    const auto hint = [&](Tool tool) {
        canvas->setTool(tool);
        return options->hint();
    };
    QVERIFY(hint(Tool::Cage).contains(QStringLiteral("a face of the cage"))); // whatever its corners
    QVERIFY(hint(Tool::Maps).contains(QStringLiteral("to select it")));
    QVERIFY(hint(Tool::DefineTriangle).contains(QStringLiteral("four corners")));
}

void WindowLayoutTest::aCageOfManyCornersIsScrolled() {
    QSettings().clear();
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->resize(1280, 700);
    window->findChild<QDockWidget*>(QStringLiteral("cage"))->raise();
    document::Fractal fractal = window->document().fractal();
    const ifs::Polygon square{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
    document::plane(fractal)->cage = ifs::polygonAtRest<2>(ifs::regularPolygonAround(square, 64));
    window->document().edit(QStringLiteral("hold"), fractal);
    auto* panel = window->findChild<view::CagePanel*>();
    QTRY_VERIFY(panel->height() > 1000);
    support::handleEvents();
    QCOMPARE(window->height(), 700);
    auto* last = panel->findChildren<view::NumberField*>().last();
    for (auto* field : panel->findChildren<view::NumberField*>())
        if (field->accessibleName() == QStringLiteral("x of vertex 64")) last = field;
    QVERIFY(last->visibleRegion().isEmpty());
    last->previousInFocusChain()->setFocus(); // and what Tab reaches is seen
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), last);
    QTRY_VERIFY(!last->visibleRegion().isEmpty());
    window->document().undoStack()->setClean();
}

// A row that appears gets its height, beside its label where there is room and below it where there is not.
void WindowLayoutTest::rowsOfASliceAppear_data() {
    QTest::addColumn<int>("width");
    QTest::newRow("wide") << 1400;
    QTest::newRow("narrow") << 800;
}

void WindowLayoutTest::rowsOfASliceAppear() {
    QFETCH(int, width);
    MainWindow* window = shown({});
    window->openPath(support::sourcePath(QStringLiteral("ifs_library/space_sponges.ifs")));
    window->resize(width, 860);
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->findChild<QDockWidget*>(QStringLiteral("appearance"))->raise();
    const auto* panel = window->findChild<view::AppearancePanel*>();
    const view::SliceRows* rows = panel->slice();
    QTRY_VERIFY(panel->isVisible() && rows->kind()->isEnabled());
    QTRY_VERIFY(rows->kind()->height() >= rows->kind()->sizeHint().height());
    for (const auto kind : {view::SliceRows::Kind::Half, view::SliceRows::Kind::Slice}) {
        support::choose(rows->kind(), kind);
        const std::array<const QWidget*, 4> shownRows{rows->kind(), rows->direction(), rows->offset(),
                                                      rows->thickness()};
        const std::size_t count = kind == view::SliceRows::Kind::Slice ? 4 : 3;
        for (std::size_t k = 0; k < count; ++k) {
            QVERIFY(shownRows[k]->isVisible());
            QTRY_VERIFY(shownRows[k]->height() >= shownRows[k]->sizeHint().height());
            if (k > 0) QTRY_VERIFY(shownRows[k]->geometry().top() > shownRows[k - 1]->geometry().bottom());
            QTRY_VERIFY(shownRows[k]->geometry().right() < panel->width());
        }
    }
}

// At the height that it has at first.
void WindowLayoutTest::theTimelineIsSeenWhole() {
    QFETCH(QString, language);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    QSettings().clear();
    MainWindow* window = shown({});
    window->resize(1024, 768);
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->findChild<QDockWidget*>(QStringLiteral("timeline"))->show();
    const auto* page = window->findChild<view::MotionPage*>();
    QTRY_VERIFY(page->isVisible());
    const auto* keys = page->findChild<QPushButton*>(); // Make Keys, at the bottom
    QTRY_COMPARE(keys->visibleRegion().boundingRect(), keys->rect());
    QCOMPARE(window->size(), QSize(1024, 768));
    QSettings().clear();
}

void WindowLayoutTest::theTimelineIsRemembered() {
    support::forgetSettings();
    bool isWanted = false;
    for (const bool shows : {true, true, false, false}) {
        MainWindow* window = shown({});
        QVERIFY(QTest::qWaitForWindowExposed(window));
        auto* timeline = window->findChild<QDockWidget*>(QStringLiteral("timeline"));
        QCOMPARE(timeline->isVisible(), isWanted);
        timeline->setVisible(shows);
        isWanted = shows;
        window->close();
        QTRY_VERIFY_WITH_TIMEOUT(windows().isEmpty(), 60'000);
    }
}

BARYCAGE_TEST(WindowLayoutTest, QApplication);
#include "window_layout_test.moc"
