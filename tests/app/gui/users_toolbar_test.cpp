// SPDX-License-Identifier: MIT
#include "actions/tool_bar.h"
#include "dialogs/preferences_dialog.h"
#include "dialogs/toolbar_page.h"
#include "support/choose.h"
#include "support/commands.h"
#include "support/named.h"
#include "support/named_test.h"
#include "window_fixture.h"

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>

// The order of tools is the user's.
class UsersToolbarTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theUsualToolsAreShown();
    void anOrderCountsInEveryWindowAndIsKept();
    void aDragMovesATool();
    void commandsAreAddedAndRemoved();
    void typingFindsACommand();
    void theLastToolStays();
    void defaultsReturnPageByPage();
    void toolsOfOtherVersionsAreSkipped();

private:
    static QStringList shown(const MainWindow& window) {
        QStringList ids;
        for (const QAction* action : window.findChild<ToolBar*>()->actions())
            ids << (action->isSeparator() ? view::separatorId() : action->objectName());
        return ids;
    }
    QStringList shown() const { return shown(*m_window); }
    QStringList usual() const { return m_window->findChild<ToolBar*>()->usualTools(); }
    static QStringList swapped(QStringList ids, int a, int b) {
        ids.swapItemsAt(a, b);
        return ids;
    }
    void openPage() {
        support::command(*m_window, "settings")->trigger();
        m_page = m_window->findChild<view::ToolbarPage*>();
        QVERIFY(m_page);
        dialog()->findChild<QTabWidget*>()->setCurrentWidget(m_page);
    }
    view::PreferencesDialog* dialog() const { return m_window->findChild<view::PreferencesDialog*>(); }
    QListWidget* list() const { return m_page->findChild<QListWidget*>(); }
    QAbstractButton* button(const char* name) const { return support::button(*m_page, name); }
    void restoreDefaults() const {
        dialog()->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
    }

    view::ToolbarPage* m_page = nullptr;
};

void UsersToolbarTest::theUsualToolsAreShown() {
    QCOMPARE(shown(), usual());
    QVERIFY(usual().size() > 8 && usual().contains(view::separatorId()));
    openPage();
    QCOMPARE(list()->count(), int(usual().size()));
    QVERIFY(!button("up")->isEnabled() && button("down")->isEnabled());
}

void UsersToolbarTest::anOrderCountsInEveryWindowAndIsKept() {
    MainWindow other;
    other.setAttribute(Qt::WA_DeleteOnClose, false);
    openPage();
    list()->setCurrentRow(1);
    button("up")->click();
    const QStringList wanted = swapped(usual(), 0, 1);
    QCOMPARE(shown(), wanted);
    QCOMPARE(shown(other), wanted);
    QCOMPARE(list()->currentRow(), 0);
    QCOMPARE(view::Preferences::stored().tools, wanted);
    QCOMPARE(shown(*std::make_unique<MainWindow>()), wanted);
    button("down")->click();
    QCOMPARE(shown(), usual());
    QVERIFY(view::Preferences::stored().tools.isEmpty()); // what later versions add is shown
}

void UsersToolbarTest::aDragMovesATool() {
    openPage();
    QVERIFY(list()->model()->moveRow({}, 2, {}, 0)); // as the list does when an item is dropped
    QStringList wanted = usual();
    wanted.move(2, 0);
    QCOMPARE(shown(), wanted);
}

void UsersToolbarTest::commandsAreAddedAndRemoved() {
    openPage();
    auto* others = m_page->findChild<QComboBox*>();
    QVERIFY(others->findData(QStringLiteral("rotate-view-left")) >= 0);
    QVERIFY(others->findData(usual().first()) < 0); // it is there
    list()->setCurrentRow(0);
    support::choose(others, QStringLiteral("rotate-view-left"));
    QStringList wanted = usual();
    wanted.insert(1, QStringLiteral("rotate-view-left"));
    QCOMPARE(shown(), wanted);
    QVERIFY(others->findData(QStringLiteral("rotate-view-left")) < 0 && !others->currentData().isValid());
    support::choose(others, view::separatorId());
    wanted.insert(2, view::separatorId());
    QCOMPARE(shown(), wanted);
    list()->setCurrentRow(1);
    button("remove")->click();
    wanted.removeAt(1);
    QCOMPARE(shown(), wanted);
    QVERIFY(others->findData(QStringLiteral("rotate-view-left")) >= 0);
}

void UsersToolbarTest::typingFindsACommand() {
    openPage();
    list()->setCurrentRow(0);
    auto* field = m_page->findChild<QComboBox*>()->lineEdit();
    field->setFocus();
    QTest::keyClicks(field, QStringLiteral("view left"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(shown().value(1), QStringLiteral("rotate-view-left"));
    QVERIFY(dialog()->isVisible());
    QTRY_VERIFY(field->text().isEmpty());
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(dialog()->isVisible());
    QCOMPARE(shown().size(), usual().size() + 1);
}

void UsersToolbarTest::theLastToolStays() {
    openPage();
    while (button("remove")->isEnabled()) {
        list()->setCurrentRow(0);
        button("remove")->click();
    }
    QCOMPARE(shown(), QStringList(usual().last()));
}

void UsersToolbarTest::defaultsReturnPageByPage() {
    view::Preferences chosen;
    chosen.labels = false;
    chosen.tools = swapped(usual(), 0, 1);
    chosen.store();
    openPage();
    restoreDefaults();
    QCOMPARE(shown(), usual());
    QVERIFY(!view::Preferences::stored().labels);
    chosen.store();
    m_page->setTools(chosen.tools);
    auto* pages = dialog()->findChild<QTabWidget*>();
    pages->setCurrentWidget(pages->widget(0));
    restoreDefaults();
    QVERIFY(view::Preferences::stored().labels);
    QCOMPARE(view::Preferences::stored().tools, chosen.tools);
}

void UsersToolbarTest::toolsOfOtherVersionsAreSkipped() {
    view::Preferences chosen;
    chosen.tools = {QStringLiteral("of-another-version"), usual().last(), view::separatorId()};
    chosen.store();
    const auto window = std::make_unique<MainWindow>();
    QCOMPARE(shown(*window), QStringList({usual().last(), view::separatorId()}));
}

BARYCAGE_TEST(UsersToolbarTest, QApplication);
#include "users_toolbar_test.moc"
