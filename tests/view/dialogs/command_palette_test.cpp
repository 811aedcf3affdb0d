// SPDX-License-Identifier: MIT
#include "dialogs/command_delegate.h"
#include "dialogs/command_palette.h"
#include "dialogs/shortcuts_dialog.h"
#include "support/languages.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "widgets/menus/menu_placeholder.h"

#include <QAction>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>
#include <QWindow>

constexpr int guide = 1; // the last row, while something is typed, leads to the guide

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

    void whatIsNoCommandIsNotListed() {
        QMenuBar bar;
        QMenu* menu = bar.addMenu(QStringLiteral("&Views"));
        menu->addAction(QStringLiteral("&Save View"));
        menu->addAction(QStringLiteral("&Edit Views"))->setEnabled(false);
        view::addPlaceholder(*menu, QStringLiteral("No saved views"));
        QStringList paths;
        for (const view::NamedAction& action : view::actionsOf(&bar))
            paths << action.path;
        QCOMPARE(paths,
                 (QStringList{QStringLiteral("Views › Save View"), QStringLiteral("Views › Edit Views")}));
    }

    // Behind the names.
    void descriptionsAreSearchedToo() {
        QMenuBar bar;
        QMenu* menu = bar.addMenu(QStringLiteral("&Edit"));
        menu->addAction(QStringLiteral("&Mutate"))
            ->setStatusTip(QStringLiteral("Breed variations of this fractal"));
        menu->addAction(QStringLiteral("Vary &Colours"));
        view::CommandPalette palette(view::actionsOf(&bar));
        auto* search = palette.findChild<QLineEdit*>();
        const QAbstractItemModel* model = palette.findChild<QListView*>()->model();
        const auto titles = [&](const QString& text) {
            search->setText(text);
            QStringList all;
            for (int row = 0; row < model->rowCount() - guide; ++row)
                all << model->index(row, 0).data().toString().section(QStringLiteral(" › "), -1);
            return all;
        };
        QCOMPARE(titles(QStringLiteral("breed")), QStringList{QStringLiteral("Mutate")});
        QCOMPARE(titles(QStringLiteral("mutate fractal")), QStringList{QStringLiteral("Mutate")});
        QCOMPARE(titles(QStringLiteral("var")),
                 QStringList({QStringLiteral("Vary Colours"), QStringLiteral("Mutate")}));
    }

    void returnRunsWhatCanBeRun() {
        QMenuBar bar;
        QMenu* menu = bar.addMenu(QStringLiteral("&Animation"));
        menu->addAction(QStringLiteral("&Play Lesson"))->setEnabled(false);
        QAction* pause = menu->addAction(QStringLiteral("Pa&use"));
        pause->setStatusTip(QStringLiteral("Play or stop the animation"));
        QSignalSpy paused(pause, &QAction::triggered);
        view::CommandPalette palette(view::actionsOf(&bar));
        auto* search = palette.findChild<QLineEdit*>();
        search->setText(QStringLiteral("play"));
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(paused.count(), 1);
    }

    void theWholeNameComesFirst() {
        QMenuBar bar;
        QMenu* menu = bar.addMenu(QStringLiteral("&View"));
        menu->addAction(QStringLiteral("Stereo, &Side by Side"))->setCheckable(true);
        QAction* wanted = menu->addAction(QStringLiteral("Side by Si&de"));
        wanted->setCheckable(true);
        view::CommandPalette palette(view::actionsOf(&bar));
        auto* search = palette.findChild<QLineEdit*>();
        const QAbstractItemModel* model = palette.findChild<QListView*>()->model();
        search->setText(QStringLiteral("side by side"));
        QCOMPARE(model->rowCount(), 2 + guide);
        QCOMPARE(model->index(0, 0).data().toString(), QStringLiteral("View › Side by Side"));
        wanted->setChecked(true); // what is on says so
        search->setText(QStringLiteral("side"));
        QCOMPARE(model->index(1, 0).data().toString(), QStringLiteral("View › Side by Side ✓"));
        QCOMPARE(model->index(0, 0).data().toString(), QStringLiteral("View › Stereo, Side by Side"));
    }

    void wholeWordsComeFirst() {
        QMenuBar bar;
        QMenu* menu = bar.addMenu(QStringLiteral("&File"));
        menu->addAction(QStringLiteral("New Window"));
        menu->addAction(QStringLiteral("Wind"))->setEnabled(false);
        menu->addAction(QStringLiteral("Gentle Wind"));
        view::CommandPalette palette(view::actionsOf(&bar));
        palette.findChild<QLineEdit*>()->setText(QStringLiteral("wind"));
        const QAbstractItemModel* model = palette.findChild<QListView*>()->model();
        QStringList titles;
        for (int row = 0; row < model->rowCount() - guide; ++row)
            titles << model->index(row, 0).data().toString();
        QCOMPARE(titles, (QStringList{QStringLiteral("File › Gentle Wind"),
                                      QStringLiteral("File › New Window"), QStringLiteral("File › Wind")}));
    }

    // What a command is called elsewhere, and what it makes.
    void synonymsFindCommands() {
        QMenuBar bar;
        QMenu* menu = bar.addMenu(QStringLiteral("&File"));
        menu->addAction(QStringLiteral("&Export Picture…"));
        menu->addAction(QStringLiteral("&Print…"));
        menu->addAction(QStringLiteral("Flip &Horizontally"));
        view::CommandPalette palette(view::actionsOf(&bar));
        const QAbstractItemModel* model = palette.findChild<QListView*>()->model();
        const auto first = [&](const char* text) {
            palette.findChild<QLineEdit*>()->setText(QString::fromLatin1(text));
            return model->index(0, 0).data().toString().section(QStringLiteral(" › "), -1);
        };
        for (const char* word : {"stl", "render", "poster", "png"})
            QCOMPARE(first(word), QStringLiteral("Export Picture"));
        QCOMPARE(first("paper"), QStringLiteral("Print"));
        QCOMPARE(first("mirror"), QStringLiteral("Flip Horizontally"));
    }

    void theGuideIsSearched() {
        QMenuBar bar;
        bar.addMenu(QStringLiteral("&File"))->addAction(QStringLiteral("&Save"));
        view::CommandPalette palette(view::actionsOf(&bar));
        QSignalSpy wanted(&palette, &view::CommandPalette::guideRequested);
        const QAbstractItemModel* model = palette.findChild<QListView*>()->model();
        QCOMPARE(model->rowCount(), 1); // nothing is typed yet
        palette.findChild<QLineEdit*>()->setText(QStringLiteral("save"));
        QCOMPARE(palette.findChild<QListView*>()->currentIndex().row(), 0);
        QCOMPARE(model->index(1, 0).data().toString(), QStringLiteral("Search the guide for “save”"));
        palette.findChild<QLineEdit*>()->setText(QStringLiteral("  lacunarity "));
        palette.show();
        QTest::keyClick(palette.findChild<QLineEdit*>(), Qt::Key_Return);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.front().front().toString(), QStringLiteral("lacunarity"));
        QVERIFY(!palette.isVisible());
    }

    void panelsAreSearchedToo() {
        QMainWindow window;
        window.menuBar()->addMenu(QStringLiteral("&Edit"))->addAction(QStringLiteral("&Undo"));
        auto* dock = new QDockWidget(QStringLiteral("Maps"), &window);
        dock->setWidget(new QWidget);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        auto* list = new QWidget(dock->widget());
        list->addAction(new QAction(QStringLiteral("D&uplicate"), list));
        list->addAction(new QAction(QStringLiteral("Delete"), list));
        list->actions().back()->setEnabled(false);
        auto* weights = new QToolButton(dock->widget());
        weights->setText(QStringLiteral("Weights"));
        weights->setMenu(new QMenu(weights));
        QSignalSpy equal(weights->menu()->addAction(QStringLiteral("Equal")), &QAction::triggered);
        auto* duplicate = new QToolButton(dock->widget()); // the same once more
        duplicate->setDefaultAction(list->actions().front());

        QStringList paths;
        for (const view::NamedAction& action : view::actionsOf(window))
            paths << action.path;
        paths.sort();
        QCOMPARE(paths,
                 (QStringList{QStringLiteral("Edit › Undo"), QStringLiteral("Maps › Delete"),
                              QStringLiteral("Maps › Duplicate"), QStringLiteral("Maps › Weights › Equal")}));

        window.show();
        dock->hide();
        view::CommandPalette palette(view::actionsOf(window));
        palette.show();
        QVERIFY(QTest::qWaitForWindowExposed(&palette));
        QTest::keyClicks(palette.findChild<QLineEdit*>(), QStringLiteral("del"));
        const auto* found = palette.findChild<QListView*>()->model();
        QCOMPARE(found->rowCount(), 1 + guide);
        QVERIFY(!(found->index(0, 0).flags() & Qt::ItemIsEnabled)); // it is shown that there is one
        QTest::keyClick(palette.findChild<QLineEdit*>(), Qt::Key_Return);
        QVERIFY(palette.isVisible());
        palette.findChild<QLineEdit*>()->clear();
        QTest::keyClicks(palette.findChild<QLineEdit*>(), QStringLiteral("zzz"));
        QCOMPARE(found->rowCount(), 1 + guide);
        QVERIFY(!(found->index(0, 0).flags() & Qt::ItemIsEnabled));
        QCOMPARE(found->index(0, 0).data().toString(), QStringLiteral("No matching commands"));
        palette.findChild<QLineEdit*>()->clear();
        QTest::keyClicks(palette.findChild<QLineEdit*>(), QStringLiteral("weights equal"));
        QCOMPARE(palette.findChild<QListView*>()->model()->rowCount(), 1 + guide);
        QTest::keyClick(palette.windowHandle(), Qt::Key_Return);
        QCOMPARE(equal.count(), 1);
        QVERIFY(dock->isVisible());
    }

    // The end of the name, and its keys at the right edge.
    void longNamesFitIntoTheList() {
        QMenuBar bar;
        QMenu* menu = bar.addMenu(QStringLiteral("&Menu"));
        const QString path = QStringLiteral("a very long name of a menu ").repeated(6);
        QAction* action = menu->addMenu(path)->addAction(QStringLiteral("Command"));
        action->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+F9")));
        view::CommandPalette palette(view::actionsOf(&bar));
        palette.show();
        QVERIFY(QTest::qWaitForWindowExposed(&palette));
        auto* list = palette.findChild<QListView*>();
        const QModelIndex item = list->model()->index(0, 0);
        QVERIFY(item.data().toString().endsWith(QStringLiteral("Command    Ctrl+Shift+F9")));
        QVERIFY(list->viewport()->rect().contains(list->visualRect(item)));
        QCOMPARE(list->horizontalScrollBar()->maximum(), 0);
        const auto seen = [&] { return list->viewport()->grab(list->visualRect(item)).toImage(); };
        const QImage before = seen();
        list->model()->setData(item, QStringLiteral("Ctrl+Shift+F8"), view::CommandDelegate::KeysRole);
        QVERIFY(seen() != before);
        list->model()->setData(item, QStringLiteral("Ctrl+Shift+F9"), view::CommandDelegate::KeysRole);
        QVERIFY(seen() == before);
        const QString name = item.data(view::CommandDelegate::NameRole).toString();
        list->model()->setData(item, name.chopped(1) + u'!', view::CommandDelegate::NameRole);
        QVERIFY(seen() != before);
    }

    void everyKeyIsSeenWhole_data() { support::addLanguages(); }
    void everyKeyIsSeenWhole() {
        QFETCH(QString, language);
        const support::Spoken spoken(language);
        QVERIFY(spoken.isInstalled());
        view::ShortcutsDialog dialog({});
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        auto* tree = dialog.findChild<QTreeWidget*>();
        dialog.resize(dialog.width(), 300); // with a bar beside the lines
        QTRY_VERIFY(tree->verticalScrollBar()->isVisible());
        QVERIFY(tree->header()->length() <= tree->viewport()->width());
        for (int i = 0; i < tree->topLevelItemCount(); ++i)
            for (int k = 0; k < tree->topLevelItem(i)->childCount(); ++k)
                for (const int column : {0, 1}) {
                    const QTreeWidgetItem* line = tree->topLevelItem(i)->child(k);
                    const QRect room = tree->visualRect(tree->indexFromItem(line, column));
                    const bool whole =
                        tree->fontMetrics().horizontalAdvance(line->text(column)) <= room.width();
                    if (column == 0 && dialog.width() >= dialog.screen()->availableSize().width())
                        QVERIFY(whole || line->toolTip(0) == line->text(0)); // no more room to be had
                    else
                        QVERIFY2(whole, qPrintable(line->text(column)));
                }
    }

    void aStepDoesNotNameTheCommand() {
        QMenuBar bar;
        QAction* undo = bar.addMenu(QStringLiteral("Edit"))->addAction(QStringLiteral("Undo Reset the cage"));
        undo->setProperty(view::commandName, QStringLiteral("&Undo"));
        QCOMPARE(view::actionsOf(&bar).front().path, QStringLiteral("Edit › Undo"));
    }
};

BARYCAGE_TEST(CommandPaletteTest, QApplication);
#include "command_palette_test.moc"
