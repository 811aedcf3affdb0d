// SPDX-License-Identifier: MIT
#include "bars/branch_bar.h"
#include "canvas/canvas_view.h"
#include "desktop/settings.h"
#include "dialogs/command_palette.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/recurring_branches.h"
#include "document/moments/animated_fractal.h"
#include "session_fixture.h"
#include "space/space_view.h"
#include "stage/stage.h"
#include "support/commands.h"
#include "support/named_test.h"
#include "welcome.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QSlider>
#include <QStatusBar>
#include <QTest>
#include <QToolBar>

#include <algorithm>

// What the menus offer, and what they say where a command would do nothing.
class ActionMenuTest : public SessionFixture {
    Q_OBJECT

private slots:
    void commandsOfThePanelsAreFound();
    void buttonsAreFoundAsCommands();
    void fieldsAreFoundAsCommands();
    void longStepsLeaveTheMenuNarrow();
    void cageCommandsAreOfferedWhereTheyDoSomething();
    void menusHaveEveryLetterOnce();
    void whatIsDisabledSaysWhy();
    void toolsOfThePlaneAreNotOfferedInSpace();
    void perspectiveIsStoredAsChosen();
    void weaveLeavesItsFocusToTheCanvas();
    void aKeyThatNobodyClaimsEnds();
    void otherDimensionsAreOneStep_data();
    void otherDimensionsAreOneStep();
};

void ActionMenuTest::commandsOfThePanelsAreFound() {
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
        {"Appearance › Brightness", {}},
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

// A field with a label is gone to.
void ActionMenuTest::fieldsAreFoundAsCommands() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowActive(window));
    const auto actions = view::actionsOf(*window);
    const auto brightness =
        std::ranges::find(actions, QStringLiteral("Appearance › Brightness"), &view::NamedAction::path);
    QVERIFY(brightness != actions.end());
    brightness->panel->show();
    brightness->panel->raise();
    brightness->action->trigger();
    QTRY_VERIFY(brightness->panel->isAncestorOf(QApplication::focusWidget()));
    QVERIFY(std::ranges::count(actions, QStringLiteral("Appearance › Palette"), &view::NamedAction::path) ==
            1);
    for (const view::NamedAction& action : actions)
        QVERIFY2(!action.path.endsWith(u':'), qPrintable(action.path));
    // What is in front already stays.
    view::CommandPalette palette(actions, window);
    palette.show();
    auto* search = palette.findChild<QLineEdit*>();
    search->setText(QStringLiteral("Panels Appearance"));
    emit search->returnPressed();
    QVERIFY(brightness->panel->isVisible());
}

void ActionMenuTest::longStepsLeaveTheMenuNarrow() {
    MainWindow* window = shown({});
    const QAction* undo = nullptr;
    for (const view::NamedAction& action : view::actionsOf(*window))
        if (action.path == QStringLiteral("Edit › Undo")) undo = action.action;
    QVERIFY(undo);
    document::Document& document = window->document();
    document::Fractal fractal = document.fractal();
    fractal.name += u'2';
    document.edit(QStringLiteral("Rename R&D"), fractal);
    QCOMPARE(undo->text(), QStringLiteral("&Undo Rename R&&D"));
    fractal.name += QString(300, u'm');
    const QString step = QStringLiteral("Rename ") + fractal.name;
    document.edit(step, fractal);
    QVERIFY(undo->text().startsWith(QStringLiteral("&Undo Rename ")));
    QVERIFY2(undo->text().size() < 100, qPrintable(undo->text()));
    QCOMPARE(undo->toolTip(), QStringLiteral("Undo ") + step); // with its keys only in the button's
    document.undoStack()->undo();
    QCOMPARE(undo->text(), QStringLiteral("&Undo Rename R&&D"));
    document.undoStack()->setClean();
}

void ActionMenuTest::buttonsAreFoundAsCommands() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    const auto command = [window](const char* path) -> QAction* {
        for (const view::NamedAction& action : view::actionsOf(*window))
            if (action.path == QString::fromUtf8(path)) return action.action;
        return nullptr;
    };
    for (const char* path : {"Cage › Show the rest cage", "Analysis › On the canvas › Hull",
                             "Analysis › On the canvas › Cylinders", "Appearance › Reset to Default",
                             "Appearance › Edit Palette", "Maps › Show columns: Effective",
                             "How It Is Built › Step by Step", "How It Is Built › Chaos Game"})
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
    const auto* bar = window->findChild<QToolBar*>(QStringLiteral("construction"));
    QVERIFY(bar->isHidden() && !command("How It Is Built › Play"));
    view::CommandPalette palette(view::actionsOf(*window));
    palette.show();
    QTest::keyClicks(palette.findChild<QLineEdit*>(), QStringLiteral("built chaos"));
    QTest::keyClick(palette.findChild<QLineEdit*>(), Qt::Key_Return);
    QVERIFY(bar->isVisible());
    QVERIFY(command("How It Is Built › Play"));
    window->document().undoStack()->setClean();
}

void ActionMenuTest::cageCommandsAreOfferedWhereTheyDoSomething() {
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
               offered("Cage › More › Unbake") == unbake;
    };
    const QList<const char*> ofThePlane{"Cage › More › Make Regular", "Cage › More › Affine Invariant Form"};
    const QList<const char*> ofBoth{"File › Export › Export Picture", "File › Export › Copy Picture",
                                    "File › Print", "Edit › Fractal › Transform",
                                    "Cage › More › Fit Minimal Canonical Simplex"};
    QVERIFY(std::all_of(ofThePlane.begin(), ofThePlane.end(), offered));
    QVERIFY(offers(false, false, true)); // at rest
    document::Fractal fractal = document.fractal();
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    document::plane(fractal)->cage->current[0] += ifs::Vector<2>(1, 1);
    document.edit(QStringLiteral("place"), fractal);
    QVERIFY(offers(true, true, false));
    document::plane(fractal)->cage->current[0] =
        document::plane(fractal)->cage->current[1]; // flat: it can be opened, and nothing else
    document.edit(QStringLiteral("flatten"), fractal);
    QVERIFY(offers(true, false, false));
    document.undoStack()->undo();
    QVERIFY(offers(true, true, false));
    document.undoStack()->undo();
    QVERIFY(offers(false, false, true));
    document::Fractal space;
    space.shape = document::Shape<3>();
    document.edit(QStringLiteral("space"), space);
    QVERIFY(offers(false, false, false));
    QVERIFY(std::none_of(ofThePlane.begin(), ofThePlane.end(), offered));
    QVERIFY(std::all_of(ofBoth.begin(), ofBoth.end(), offered));
    QVERIFY(!offered("File › Revert")); // it has no file
    document.undoStack()->setClean();
}

// The panels beside the canvas do not take the keys of the bar, either.
void ActionMenuTest::menusHaveEveryLetterOnce() {
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

void ActionMenuTest::whatIsDisabledSaysWhy() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowActive(window));
    QAction* bake = nullptr;
    for (auto* action : window->findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+B"))) bake = action;
    QVERIFY(bake && !bake->isEnabled());
    const QString why = document::bakeObstacle(window->document().fractal());
    QVERIFY(!why.isEmpty());
    QCOMPARE(bake->statusTip(), why);
    QCOMPARE(bake->toolTip(), why);
    for (const QAction* menu : window->menuBar()->actions())
        QVERIFY(menu->menu()->toolTipsVisible());
    QTest::keyClick(window->findChild<view::CanvasView*>(), Qt::Key_B, Qt::ControlModifier);
    QCOMPARE(window->statusBar()->currentMessage(), why);
    // Once it can be done the key does it.
    document::Fractal fractal = window->document().fractal();
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    document::plane(fractal)->cage->current[0] += ifs::Vector<2>(1, 1);
    window->document().edit(QStringLiteral("place"), fractal);
    QVERIFY(bake->isEnabled() && bake->statusTip() != why);
    QTest::keyClick(window->findChild<view::CanvasView*>(), Qt::Key_B, Qt::ControlModifier);
    QCOMPARE(window->document().undoStack()->count(), 2);
    window->document().undoStack()->setClean();
}

void ActionMenuTest::toolsOfThePlaneAreNotOfferedInSpace() {
    using Tool = view::CanvasView::Tool;
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowActive(window));
    auto* canvas = window->findChild<view::CanvasView*>();
    QTest::keyClick(canvas, Qt::Key_M);
    QCOMPARE(canvas->tool(), Tool::Maps);
    document::Fractal fractal = window->document().fractal();
    document::Shape<3> half;
    for (int side = 0; side < 2; ++side)
        ifs::append<3>(half.system, {0.5 * ifs::Matrix<3>::Identity(), ifs::Vector<3>(side / 2.0, 0, 0)});
    fractal.shape = half;
    window->document().edit(QStringLiteral("space"), fractal);
    QCOMPARE(canvas->tool(), Tool::Cage);
    const QString why = document::planeObstacle(window->document().fractal());
    for (const Qt::Key key : {Qt::Key_G, Qt::Key_A, Qt::Key_Y}) {
        window->statusBar()->clearMessage();
        QTest::keyClick(window->focusWidget(), key);
        QCOMPARE(window->statusBar()->currentMessage(), why);
        QCOMPARE(canvas->tool(), Tool::Cage);
    }
    QTest::keyClick(window->focusWidget(), Qt::Key_D); // four clicks define a tetrahedron
    QCOMPARE(canvas->tool(), Tool::DefineTriangle);
    QTest::keyClick(window->focusWidget(), Qt::Key_B); // a click of its own selects a branch there
    QCOMPARE(canvas->tool(), Tool::Branch);
    const auto* branches = window->findChild<view::BranchBar*>();
    QVERIFY(branches->depth()->isVisible());
    for (int choice = 0; choice < branches->edit()->count(); ++choice)
        QVERIFY(branches->edit()->model()->index(choice, 0).flags() & Qt::ItemIsEnabled);
    QTest::keyClick(window->focusWidget(), Qt::Key_M);
    QCOMPARE(canvas->tool(), Tool::Maps);
    // The list of maps is edited in space as well.
    const auto chosen = [&](const QString& text) {
        const auto actions = window->findChildren<QAction*>();
        const auto found = std::ranges::find(actions, text, &QAction::text);
        if (found != actions.end() && (*found)->isEnabled()) (*found)->trigger();
        return document::system3(window->document().fractal())->maps.size();
    };
    QCOMPARE(chosen(QStringLiteral("Select &All Maps")), std::size_t(2));
    QCOMPARE(chosen(QStringLiteral("&Duplicate Maps")), std::size_t(4));
    QCOMPARE(chosen(QStringLiteral("D&elete Maps")), std::size_t(2)); // the copies, which are selected now
    window->document().undoStack()->undo();
    window->document().undoStack()->undo();
    QTest::keyClick(window->focusWidget(), Qt::Key_D);
    window->document().undoStack()->undo();
    QTest::keyClick(window->focusWidget(), Qt::Key_M);
    QCOMPARE(canvas->tool(), Tool::Maps);
    window->document().undoStack()->setClean();
}

// Not to the next field, which would take the next keys for text.
void ActionMenuTest::weaveLeavesItsFocusToTheCanvas() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowActive(window));
    auto* canvas = window->findChild<view::CanvasView*>();
    document::Fractal fractal = window->document().fractal();
    fractal.shape = document::Shape<3>{document::System3{}};
    for (int side = 0; side < 2; ++side)
        ifs::append<3>(document::space(fractal)->system,
                       {0.5 * ifs::Matrix<3>::Identity(), ifs::Vector<3>(side / 2.0, 0, 0)});
    window->document().edit(QStringLiteral("space"), fractal);
    QTest::keyClick(window->focusWidget(), Qt::Key_M);
    const auto views = window->findChildren<view::SpaceView*>();
    const auto seen = std::ranges::find_if(views, [](const auto* view) { return view->isVisible(); });
    QVERIFY(seen != views.end());
    (*seen)->holdMap(1);
    QSlider* weave = window->findChild<view::BranchBar*>()->swing();
    weave->setFocus();
    QTRY_COMPARE(QApplication::focusWidget(), weave);
    window->document().undoStack()->undo();
    QTRY_COMPARE(QApplication::focusWidget(), canvas);
    const auto* plane = document::system2(window->document().fractal());
    canvas->selectMaps({plane->maps[0].id});
    weave->setFocus();
    QTRY_COMPARE(QApplication::focusWidget(), weave);
    canvas->selectMaps({});
    QTRY_COMPARE(QApplication::focusWidget(), canvas);
}

// A view along an axis is orthographic for a while, and not what the next window begins with.
void ActionMenuTest::perspectiveIsStoredAsChosen() {
    const auto isStored = [] { return view::stored(QStringLiteral("space/perspective")).toBool(); };
    MainWindow* window = shown({});
    window->document().edit(QStringLiteral("solid"), pairOfCubes());
    view::SpaceNavigation& navigation = window->findChild<Stage*>()->space()->navigation();
    const QList<QAction*> actions = window->actions();
    QAction* perspective = *std::ranges::find(actions, QStringLiteral("&Perspective"), &QAction::text);
    QVERIFY(!perspective->isChecked());
    perspective->trigger();
    QVERIFY(navigation.isPerspective() && isStored());
    navigation.lookFrom(view::directions::front);
    QVERIFY(!perspective->isChecked() && isStored());
    navigation.leaveAxisView();
    QVERIFY(perspective->isChecked());
    perspective->trigger();
    QVERIFY(!navigation.isPerspective() && !isStored());
    window->document().undoStack()->setClean();
}

// Copy and the like press their key for the widget with the focus. Where it has no use for the key, the
// shortcut of the command must not run again.
void ActionMenuTest::aKeyThatNobodyClaimsEnds() {
    MainWindow* window = shown({});
    window->openFirstPicture();
    QVERIFY(QTest::qWaitForWindowActive(window));
    const QList<QKeySequence> keys{QKeySequence::Copy,   QKeySequence::Cut,
                                   QKeySequence::Paste,  QKeySequence::SelectAll,
                                   QKeySequence::Delete, QKeySequence(Qt::Key_Insert)};
    int pressed = 0;
    for (auto* widget : window->findChildren<QWidget*>()) {
        if (!widget->isVisible() || !widget->isEnabled() || widget->focusPolicy() == Qt::NoFocus) continue;
        const QPointer<QWidget> guard = widget;
        for (const QAction* menu : window->menuBar()->actions())
            for (QAction* action : menu->menu()->actions()) {
                if (!guard || !keys.contains(action->shortcut())) continue;
                guard->setFocus();
                action->trigger();
                ++pressed;
            }
    }
    QVERIFY(pressed > 50);
    window->document().undoStack()->setClean();
}

void ActionMenuTest::otherDimensionsAreOneStep_data() {
    QTest::addColumn<document::Fractal>("fractal");
    QTest::addColumn<QString>("obstacle"); // of lifting
    QTest::addColumn<QString>("loss");
    QTest::addColumn<QString>("wayBack"); // its obstacle
    const document::Fractal plain = document::sierpinskiTriangle();
    const auto& maps = document::system2(plain)->maps;
    const auto row = [&](const char* name, auto change, const char* obstacle, const char* loss,
                         const char* wayBack) {
        document::Fractal fractal = plain;
        change(*document::plane(fractal));
        QTest::newRow(name) << fractal << QString::fromLatin1(obstacle) << QString::fromLatin1(loss)
                            << QString::fromLatin1(wayBack);
    };
    using Plane = document::Shape<2>;
    const ifs::AffineMap<2> aside{0.9 * ifs::Matrix<2>::Identity(), {0.5, 0.25}};
    row(
        "plain", [](Plane&) {}, "", "", "");
    row(
        "only here",
        [&](Plane& shape) {
            shape.moved = {{{maps[0].id, maps[1].id}, aside}};
        },
        "", "", "moved branches");
    row(
        "here and inside it",
        [&](Plane& shape) {
            shape.moved = {{document::recurringWord({maps[0].id}), aside}};
        },
        "", "", "moved branches");
    row(
        "animated",
        [&](Plane& shape) {
            shape.animation.emplace().maps = {
                {maps[0].id, {{0, {maps[0].map, 1.0}, {}}, {48, {maps[1].map, 1.0}, {}}}}};
        },
        "", "animation", "");
    row(
        "five corners",
        [](Plane& shape) {
            shape.cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {1.2, 0.7}, {0.5, 1}, {-0.2, 0.7}});
            shape.cage->current[3] = {0.6, 1.4};
        },
        "corners", "", "");
    row(
        "linked",
        [&](Plane& shape) {
            shape.system.links = {{maps[0].id, maps[1].id, 0}};
        },
        "linked", "", "");
}

// What cannot be done, or would be lost, is said before; undo restores every bit.
void ActionMenuTest::otherDimensionsAreOneStep() {
    QFETCH(const document::Fractal, fractal);
    QFETCH(const QString, obstacle);
    QFETCH(const QString, loss);
    QFETCH(const QString, wayBack);
    MainWindow* window = shown({});
    document::Document& document = window->document();
    document.setFile(document::fileOf(fractal));
    QAction* lift = support::command(*window, "lift-to-space");
    QAction* flatten = support::command(*window, "flatten-to-the-plane");
    const auto tells = [](const QAction* action, const QString& what) {
        return action->statusTip().contains(what) && action->toolTip().contains(what);
    };
    QCOMPARE(lift->isEnabled(), obstacle.isEmpty());
    QVERIFY2(tells(lift, obstacle + loss), qPrintable(lift->statusTip()));
    lift->trigger();
    QCOMPARE(document.undoStack()->count(), obstacle.isEmpty() ? 1 : 0);
    if (!obstacle.isEmpty()) return;
    const document::Fractal solid = document.entryFractal();
    QVERIFY(document::space(solid) && !document::animationFacts(solid));
    QCOMPARE(document::space(solid)->moved.size(), document::plane(fractal)->moved.size());
    QVERIFY(loss.isEmpty() || window->statusBar()->currentMessage().contains(loss));
    QVERIFY(!lift->statusTip().contains(QStringLiteral("left out"))); // it is gone
    QCOMPARE(flatten->isEnabled(), wayBack.isEmpty());
    QVERIFY2(tells(flatten, wayBack), qPrintable(flatten->statusTip()));
    flatten->trigger();
    QCOMPARE(document.undoStack()->count(), wayBack.isEmpty() ? 2 : 1);
    if (wayBack.isEmpty()) {
        QVERIFY(loss.isEmpty() ? document::isSameSystem(document.entryFractal(), fractal)
                               : document::plane(document.entryFractal()) != nullptr);
        document.undoStack()->undo();
        QVERIFY(document.entryFractal() == solid);
    }
    document.undoStack()->undo();
    QVERIFY(document.entryFractal() == fractal);
    QVERIFY2(tells(lift, loss), qPrintable(lift->statusTip()));
    document.undoStack()->redo();
    QVERIFY(document.entryFractal() == solid);
    document.undoStack()->setClean();
}

BARYCAGE_TEST(ActionMenuTest, QApplication);
#include "action_menu_test.moc"
