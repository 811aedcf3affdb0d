// SPDX-License-Identifier: MIT
#include "dialogs/command_palette.h"

#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QSignalSpy>
#include <QTest>
#include <QWindow>

class CommandPaletteTest : public QObject {
    Q_OBJECT

private slots:
    void wordsBeginWords_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("found");
        QTest::newRow("nothing typed") << QString() << true;
        QTest::newRow("beginning of a word") << QStringLiteral("can") << true;
        QTest::newRow("two words in any order") << QStringLiteral("simp FIT") << true;
        QTest::newRow("middle of a word") << QStringLiteral("plex") << false;
        QTest::newRow("one word too many") << QStringLiteral("fit circle") << false;
    }
    void wordsBeginWords() {
        QFETCH(QString, text);
        QFETCH(bool, found);
        QCOMPARE(view::matchesCommand(QStringLiteral("Cage › Fit Canonical Simplex"), text), found);
    }

    void keysReachTheSearchAndReturnRuns() {
        QMenuBar bar;
        QMenu* menu = bar.addMenu(QStringLiteral("&Cage"));
        QSignalSpy reset(menu->addAction(QStringLiteral("&Reset")), &QAction::triggered);
        QSignalSpy bake(menu->addAction(QStringLiteral("&Bake")), &QAction::triggered);
        view::CommandPalette palette(view::actionsOf(&bar));
        palette.show();
        QVERIFY(QTest::qWaitForWindowExposed(&palette));
        QTest::keyClick(palette.windowHandle(), Qt::Key_B);
        QCOMPARE(palette.findChild<QLineEdit*>()->text(), QStringLiteral("b"));
        QTest::keyClick(palette.windowHandle(), Qt::Key_Return);
        QCOMPARE(bake.count(), 1);
        QCOMPARE(reset.count(), 0);
        QVERIFY(!palette.isVisible());
    }
};

QTEST_MAIN(CommandPaletteTest)
#include "command_palette_test.moc"
