// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"
#include "desktop/preferences.h"
#include "desktop/settings.h"
#include "dialogs/command_palette.h"
#include "document/fractal/fractal_geometry.h"
#include "panels/collection/collection_panel.h"
#include "support/languages.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "window_fixture.h"

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

#include <algorithm>

// What meets somebody who opens the program for the first time: few things, with names.
class FirstSightTest : public WindowFixture {
    Q_OBJECT

private slots:
    void menusAreShort();
    void buttonsAreFewAndHaveNames();
    void namesAreAMatterOfTaste();
    void panelsAreFew();
    void namesOfPanelsAreSeenWhole_data();
    void namesOfPanelsAreSeenWhole();
    void theListOfEntriesComesWithEntries();
    void theListOfEntriesStaysAway();
    void theListOfEntriesComesInEveryWindow();
    void aChoiceThatIsThereAlreadyIsSelected();
    void whatIsNotSeenIsFound_data();
    void whatIsNotSeenIsFound();

private:
    bool isThere(const char* panel) const {
        return !m_window->findChild<QDockWidget*>(QLatin1String(panel))->isHidden();
    }
};

// A menu of a menu is one item.
void FirstSightTest::menusAreShort() {
    int count = 0;
    for (const QAction* menu : m_window->menuBar()->actions()) {
        const QList<QAction*> items = menu->menu()->actions();
        count += int(std::ranges::count_if(
            items, [](const QAction* item) { return item->isVisible() && !item->isSeparator(); }));
    }
    QVERIFY2(count <= 60, qPrintable(QString::number(count)));
}

void FirstSightTest::buttonsAreFewAndHaveNames() {
    const auto* bar = m_window->findChild<QToolBar*>(QStringLiteral("tools"));
    int count = 0;
    for (QAction* action : bar->actions()) {
        if (action->isSeparator()) continue;
        ++count;
        const auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
        QCOMPARE(button->toolButtonStyle(), Qt::ToolButtonTextUnderIcon);
        const QString name = button->text();
        QVERIFY2(!name.isEmpty() && name.size() <= 12 && !name.contains(u'…'), qPrintable(name));
        QVERIFY2(button->width() >= button->fontMetrics().horizontalAdvance(name), qPrintable(name));
    }
    QVERIFY2(count <= 10, qPrintable(QString::number(count)));
}

void FirstSightTest::namesAreAMatterOfTaste() {
    const auto* bar = m_window->findChild<QToolBar*>(QStringLiteral("tools"));
    view::Preferences preferences = view::Preferences::stored();
    preferences.labels = false;
    m_window->adopt(preferences);
    QCOMPARE(bar->toolButtonStyle(), Qt::ToolButtonIconOnly);
    preferences.store();
    const MainWindow next;
    QCOMPARE(next.findChild<QToolBar*>(QStringLiteral("tools"))->toolButtonStyle(), Qt::ToolButtonIconOnly);
    m_window->adopt({});
    QCOMPARE(bar->toolButtonStyle(), Qt::ToolButtonTextUnderIcon);
}

void FirstSightTest::panelsAreFew() {
    QStringList seen;
    for (const auto* panel : m_window->findChildren<QDockWidget*>())
        if (!panel->isHidden()) seen << panel->objectName();
    QVERIFY2(seen.size() <= 4, qPrintable(seen.join(u' ')));
    QVERIFY(isThere("maps") && isThere("cage") && isThere("appearance") && isThere("collection"));
}

void FirstSightTest::theListOfEntriesComesWithEntries() {
    QVERIFY(!isThere("entries"));
    QVERIFY(m_window->openPath(QFINDTESTDATA("../../../ifs_library/ferns.ifs")));
    QTRY_VERIFY(isThere("entries"));
    // It is the user's now: what he closes stays closed.
    m_window->findChild<QDockWidget*>(QStringLiteral("entries"))->close();
    QVERIFY(m_window->openPath(QFINDTESTDATA("../../../ifs_library/dragons.ifs")));
    QTRY_VERIFY(m_window->path().endsWith(QLatin1String("dragons.ifs")));
    QVERIFY(!isThere("entries"));
}

void FirstSightTest::theListOfEntriesStaysAway() {
    document::Document& document = m_window->document();
    document::Fractal fractal = document.fractal();
    fractal.name = QStringLiteral("another name");
    document.edit(QStringLiteral("Rename"), fractal);
    QVERIFY(!isThere("entries"));
}

// The layout of the last window says nothing about the next file.
void FirstSightTest::theListOfEntriesComesInEveryWindow() {
    m_window->close(); // without the list
    view::finishStoring();
    m_window = std::make_unique<MainWindow>();
    m_window->setAttribute(Qt::WA_DeleteOnClose, false);
    for (const char* file : {"ferns", "dragons"}) {
        m_window->findChild<QDockWidget*>(QStringLiteral("entries"))->hide(); // by the program
        QVERIFY(m_window->openPath(
            support::sourcePath(QStringLiteral("ifs_library/%1.ifs").arg(QLatin1String(file)))));
        QVERIFY(m_window->document().file().entries.size() > 1);
        QVERIFY2(isThere("entries"), file);
    }
}

void FirstSightTest::aChoiceThatIsThereAlreadyIsSelected() {
    document::Document& document = m_window->document();
    auto* panel = m_window->findChild<view::CollectionPanel*>();
    document::Fractal own = document.fractal();
    own.comments << QStringLiteral(" mine");
    document.edit(QStringLiteral("Write"), own); // so that it is kept
    const qsizetype before = document.file().entries.size();
    document::Fractal chosen = document::sierpinskiTriangle();
    emit panel->chosen({chosen});
    const document::EntryId added = document.currentId();
    QCOMPARE(document.file().entries.size(), before + 1);
    document.setCurrent(document.file().entries.front().id);
    const int steps = document.undoStack()->index();
    emit panel->chosen({chosen});
    QCOMPARE(document.currentId(), added);
    QCOMPARE(document.undoStack()->index(), steps);
    // An edited one is no longer what is in the collection.
    own = document.entryFractal();
    document::plane(own)->system.maps.front().map.linear *= 0.9;
    document.edit(QStringLiteral("Edit"), own);
    emit panel->chosen({chosen});
    QCOMPARE(document.file().entries.size(), before + 2);
    document.undoStack()->setClean();
}

void FirstSightTest::whatIsNotSeenIsFound_data() {
    QTest::addColumn<QString>("id");
    for (const char* id : {"zoom-in", "reset", "bake", "unbake", "place", "rewrite", "define", "fit-simplex",
                           "how-it-is-built", "duplicate-maps", "key", "shadow", "snapshot", "collection",
                           "panel-analysis", "panel-history", "panel-entries", "perspective"})
        QTest::newRow(id) << QString::fromLatin1(id);
}

void FirstSightTest::whatIsNotSeenIsFound() {
    QFETCH(QString, id);
    const QList<view::NamedAction> found = view::actionsOf(*m_window);
    QVERIFY(std::ranges::any_of(
        found, [&](const view::NamedAction& command) { return command.action->objectName() == id; }));
}

void FirstSightTest::namesOfPanelsAreSeenWhole_data() {
    support::addLanguages();
}

void FirstSightTest::namesOfPanelsAreSeenWhole() {
    QFETCH(QString, language);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    MainWindow window;
    for (const char* id : {"analysis", "history"})
        window.findChild<QDockWidget*>(QLatin1String(id))->show();
    window.resize(1024, 768);
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    int names = 0;
    for (const auto* bar : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        for (int i = 0; i < bar->count(); ++i, ++names) {
            const QSize room = bar->tabRect(i).size();
            const int needed = bar->fontMetrics().horizontalAdvance(bar->tabText(i));
            QVERIFY2(std::max(room.width(), room.height()) > needed, qPrintable(bar->tabText(i)));
            QVERIFY(bar->rect().contains(bar->tabRect(i)));
        }
    QCOMPARE(names, 5);
    const int half = window.findChild<view::CanvasView*>()->width() * 100 / 46;
    QVERIFY2(half >= window.width(), "the panels are too wide in this language");
}

BARYCAGE_TEST(FirstSightTest, QApplication);
#include "first_sight_test.moc"
