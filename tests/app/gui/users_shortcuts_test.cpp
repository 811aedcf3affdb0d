// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_note.h"
#include "desktop/settings.h"
#include "desktop/shortcuts.h"
#include "dialogs/command_palette.h"
#include "dialogs/preferences_dialog.h"
#include "dialogs/shortcuts_page.h"
#include "support/commands.h"
#include "support/named.h"
#include "support/named_test.h"
#include "window_fixture.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTreeWidget>

// The keys of commands are the user's.
class UsersShortcutsTest : public WindowFixture {
    Q_OBJECT

private slots:
    void everyCommandHasAName();
    void aChosenShortcutCountsInEveryWindow();
    void aChosenShortcutIsKept();
    void whatNoCommandHasIsKept();
    void keysOfOthersAreSwapped();
    void keysOfTheCanvasAreRefused();
    void sentencesNameTheKeysOfTheUser();
    void defaultsReturn();

private:
    QAction* command(const char* id, const MainWindow* window = nullptr) const {
        return support::command(window ? *window : *m_window, id);
    }
    void openPage() {
        command("settings")->trigger();
        m_page = m_window->findChild<view::ShortcutsPage*>();
        QVERIFY(m_page);
    }
    void select(const char* id) {
        auto* tree = m_page->findChild<QTreeWidget*>();
        for (QTreeWidgetItemIterator item(tree); *item; ++item)
            if ((*item)->data(0, Qt::UserRole).value<QAction*>() == command(id))
                return tree->setCurrentItem(*item);
        QFAIL(id);
    }
    void type(const QKeySequence& keys) { m_page->findChild<QKeySequenceEdit*>()->setKeySequence(keys); }
    QAbstractButton* button(const char* name) const { return support::button(*m_page, name); }
    QString note() const { return m_page->findChild<QLabel*>(QStringLiteral("note"))->text(); }

    view::ShortcutsPage* m_page = nullptr;
};

// Names are what the user's keys are stored under.
void UsersShortcutsTest::everyCommandHasAName() {
    QMap<QString, const QAction*> named;
    int count = 0;
    for (const view::NamedAction& found : view::actionsOf(m_window->menuBar())) {
        if (!m_window->actions().contains(found.action)) continue; // a file, an entry, a view
        const QString id = found.action->objectName();
        QVERIFY2(!id.isEmpty(), qPrintable(found.path));
        QVERIFY2(!named.contains(id) || named[id] == found.action, qPrintable(id));
        named[id] = found.action;
        ++count;
    }
    QVERIFY2(count > 90, qPrintable(QString::number(count)));
}

void UsersShortcutsTest::aChosenShortcutCountsInEveryWindow() {
    MainWindow other;
    const QKeySequence chosen(QStringLiteral("Ctrl+J"));
    view::setShortcuts(QStringLiteral("fit"), view::Shortcuts{chosen});
    MainWindow later;
    for (const MainWindow* window : {m_window.get(), &other, &later}) {
        QCOMPARE(command("fit", window)->shortcut(), chosen);
        QVERIFY(command("fit", window)->whatsThis().contains(chosen.toString(QKeySequence::NativeText)));
    }
    QSignalSpy fitted(command("fit"), &QAction::triggered);
    QTest::keyClick(m_window.get(), Qt::Key_J, Qt::ControlModifier);
    QCOMPARE(fitted.count(), 1);
    QTest::keyClick(m_window.get(), Qt::Key_F);
    QCOMPARE(fitted.count(), 1);
    view::setShortcuts(QStringLiteral("fit"), std::nullopt);
    QTest::keyClick(m_window.get(), Qt::Key_F);
    QCOMPARE(fitted.count(), 2);
}

void UsersShortcutsTest::aChosenShortcutIsKept() {
    view::setShortcuts(QStringLiteral("fit"), view::Shortcuts{});
    QVERIFY(view::finishStoring());
    QCOMPARE(QSettings().value(QStringLiteral("shortcuts/fit")), QVariant(QString()));
    QVERIFY(command("fit", std::make_unique<MainWindow>().get())->shortcuts().isEmpty());
    view::setShortcuts(QStringLiteral("fit"), std::nullopt);
    QVERIFY(view::finishStoring());
    QVERIFY(!QSettings().contains(QStringLiteral("shortcuts/fit")));
}

void UsersShortcutsTest::whatNoCommandHasIsKept() {
    view::store(QStringLiteral("shortcuts/of-a-later-version"), QStringLiteral("Ctrl+J"));
    openPage();
    m_page->restoreDefaults();
    QVERIFY(view::finishStoring());
    QCOMPARE(QSettings().value(QStringLiteral("shortcuts/of-a-later-version")).toString(),
             QStringLiteral("Ctrl+J"));
}

void UsersShortcutsTest::keysOfOthersAreSwapped() {
    openPage();
    select("mutate");
    const QKeySequence fit = command("fit")->shortcut(), mutate = command("mutate")->shortcut();
    type(fit);
    QVERIFY2(note().contains(QStringLiteral("belongs to “Fit")), qPrintable(note()));
    QCOMPARE(command("mutate")->shortcut(), mutate); // not yet
    QVERIFY(!button("swap")->isHidden());
    button("swap")->click();
    QCOMPARE(command("mutate")->shortcut(), fit);
    QCOMPARE(command("fit")->shortcut(), mutate);
    QVERIFY(button("swap")->isHidden());
    QVERIFY2(note().contains(mutate.toString(QKeySequence::NativeText)), qPrintable(note()));
}

void UsersShortcutsTest::sentencesNameTheKeysOfTheUser() {
    auto* canvas = m_window->findChild<view::CanvasView*>();
    QSignalSpy said(canvas, &view::CanvasView::message);
    const auto hint = [&] {
        command("hide")->setChecked(true);
        const QString sentence = said.last().first().toString();
        command("hide")->setChecked(false);
        return sentence;
    };
    QVERIFY(hint().contains(QStringLiteral("Press H ")));
    view::setShortcuts(QStringLiteral("hide"), view::Shortcuts{QKeySequence(QStringLiteral("Ctrl+J"))});
    QVERIFY(hint().contains(QStringLiteral("Press Ctrl+J ")));
    view::setShortcuts(QStringLiteral("hide"), view::Shortcuts{});
    QVERIFY2(hint().contains(QStringLiteral("Press “Only the Picture” ")),
             qPrintable(said.last().first().toString()));
    view::setShortcuts(QStringLiteral("hide"), std::nullopt);
    view::setShortcuts(QStringLiteral("fit"), view::Shortcuts{QKeySequence(QStringLiteral("Ctrl+0"))});
    QVERIFY(view::nothingHere().contains(QStringLiteral("Press Ctrl+0 ")));
    view::setShortcuts(QStringLiteral("fit"), std::nullopt);
    QVERIFY(view::nothingHere().contains(QStringLiteral("Press F ")));
}

void UsersShortcutsTest::keysOfTheCanvasAreRefused() {
    openPage();
    select("mutate");
    const QKeySequence before = command("mutate")->shortcut();
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Space, Qt::Key_Escape}) {
        type(QKeySequence(key));
        QVERIFY(note().contains(QKeySequence(key).toString(QKeySequence::NativeText)));
        QCOMPARE(command("mutate")->shortcut(), before);
        QVERIFY(button("swap")->isHidden());
    }
    type(QKeySequence(Qt::CTRL | Qt::Key_Left));
    QCOMPARE(command("mutate")->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_Left));
}

void UsersShortcutsTest::defaultsReturn() {
    openPage();
    select("redo");
    const view::Shortcuts usual = command("redo")->shortcuts();
    QCOMPARE(usual.size(), 2);
    QVERIFY(!button("default")->isEnabled());
    button("clear")->click();
    QVERIFY(command("redo")->shortcuts().isEmpty());
    button("default")->click();
    QCOMPARE(command("redo")->shortcuts(), usual);
    type(QKeySequence(QStringLiteral("Ctrl+J")));
    select("fit");
    type(QKeySequence(QStringLiteral("Ctrl+Shift+J")));
    auto* dialog = m_window->findChild<view::PreferencesDialog*>();
    dialog->findChild<QTabWidget*>()->setCurrentWidget(m_page);
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
    QCOMPARE(command("redo")->shortcuts(), usual);
    QCOMPARE(command("fit")->shortcut(), QKeySequence(QStringLiteral("F")));
}

BARYCAGE_TEST(UsersShortcutsTest, QApplication);
#include "users_shortcuts_test.moc"
