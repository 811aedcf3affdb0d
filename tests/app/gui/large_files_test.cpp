// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/geometry/canvas_part.h"
#include "canvas/scene/canvas_scene.h"
#include "dialogs/variations/mutate_dialog.h"
#include "dialogs/variations/picture_tiles.h"
#include "main_window.h"
#include "panels/cage/cage_panel.h"
#include "panels/collection/collection_panel.h"
#include "panels/entries/entries_panel.h"
#include "panels/maps/maps_model.h"
#include "panels/maps/maps_panel.h"
#include "support/background_rest.h"
#include "support/commands.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"
#include "support/thorough.h"
#include "support/watchdog.h"

#include <QAction>
#include <QDialog>
#include <QFile>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QPointer>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QWhatsThis>

#include <functional>

using namespace std::chrono_literals;

namespace {

support::WatchedApplication* application() {
    return static_cast<support::WatchedApplication*>(QCoreApplication::instance());
}

void putFile(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("no test file");
}

QByteArray rows(int count, const QByteArray& linear = ".01 0 0 .01 ") {
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += linear + QByteArray::number(i % 317) + ' ' + QByteArray::number(i / 317) + " .00001\n";
    return text;
}

// A square of n times n copies that can all be distinguished.
QByteArray squareSvg(int side) {
    QByteArray text = "square {\n";
    for (int i = 0; i < side * side; ++i)
        text += QByteArray::number(0.8 / side) + " 0 0 " + QByteArray::number(0.8 / side) + ' ' +
                QByteArray::number(double(i % side) / side) + ' ' +
                QByteArray::number(double(i / side) / side) + " 1\n";
    return text + "}\n";
}

QByteArray entries(int count, int maps, const QByteArray& comment = {}) {
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += "entry" + QByteArray::number(i) + " {" + comment + '\n' + rows(maps) + "}\n";
    return text;
}

} // namespace

// Whatever is done to large files, the window answers: no event keeps it longer than the watchdog allows.
class LargeFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QApplication::setQuitOnLastWindowClosed(false); }
    void init() {
        support::useOwnSettings();
        m_window = new MainWindow;
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window));
        QVERIFY(support::backgroundRests());
        application()->takeLate();
    }
    void cleanup() {
        delete m_window;
        application()->takeLate();
    }

    void entriesAreEdited_data();
    void entriesAreEdited();
    void mapsAreSelected();
    void mapsAreEdited_data();
    void mapsAreEdited();
    void framesOfManyMapsAreDragged();
    void branchesAreFoundAmongManyMaps();
    void workIsRecovered();
    void aFolderIsBrowsed();
    void everyCommandIsChosen(); // the last one: it leaves settings behind

private:
    // As an event of its own, and until what follows is done.
    void doing(const QByteArray& what, const std::function<void()>& action) {
        bool isDone = false;
        QMetaObject::invokeMethod(
            this,
            [&] {
                action();
                isDone = true;
            },
            Qt::QueuedConnection);
        QTRY_VERIFY(isDone);
        // Timers start what follows, which has no end that is told: those of the program run for less than
        // this.
        QTest::qWait(150);
        for (const QString& late : application()->takeLate())
            m_late << QString::fromUtf8(what) + QStringLiteral(": ") + late;
    }
    QString takeLate() { return std::exchange(m_late, {}).join(u'\n'); }
    void openLarge(const QByteArray& text) {
        const QString path = m_folder.filePath(QStringLiteral("large.ifs"));
        putFile(path, text);
        doing("open", [&] { m_window->openPath(path); });
    }
    // Parts of mapsAreEdited(), on an entry of `count` maps.
    void dragTheCage();
    void editMaps(int count);
    void openDialogs();
    void editABranch(int count);
    void moveEveryMap(int count);
    void editTheTable(int count);

    QTemporaryDir m_folder;
    QPointer<MainWindow> m_window;
    QStringList m_late;
};

void LargeFilesTest::entriesAreEdited_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("20 000 entries") << entries(20'000, 2);
    if (!support::isThorough()) return;
    QTest::newRow("100 000 entries") << entries(100'000, 2);
    QTest::newRow("100 MB") << entries(10'000, 2, " ; " + QByteArray(10'000, 'x'));
}

void LargeFilesTest::entriesAreEdited() {
    QFETCH(QByteArray, text);
    openLarge(text);
    auto* panel = m_window->findChild<view::EntriesPanel*>();
    auto* list = panel->findChild<QListView*>();
    auto* filter = panel->findChild<QLineEdit*>();
    QUndoStack* history = m_window->document().undoStack();
    const auto press = [&](Qt::Key key) { return [list, key] { QTest::keyClick(list, key); }; };
    doing("next", press(Qt::Key_Down));
    doing("last", press(Qt::Key_End));
    doing("first", press(Qt::Key_Home));
    doing("scroll", [&] { list->verticalScrollBar()->setValue(list->verticalScrollBar()->maximum() / 2); });
    doing("filter", [&] { filter->setText(QStringLiteral("9")); });
    doing("filter more", [&] { filter->setText(QStringLiteral("99")); });
    doing("filter no more", [&] { filter->clear(); });
    doing("rename", [&] {
        document::Fractal fractal = m_window->document().fractal();
        fractal.name = QStringLiteral("mine");
        m_window->document().edit(QStringLiteral("rename"), fractal);
    });
    doing("undo", [&] { history->undo(); });
    doing("redo", [&] { history->redo(); });
    doing("remove", [&] { panel->removeSelected(); });
    doing("undo removing", [&] { history->undo(); });
    doing("add", [&] { panel->addEntry(); });
    doing("move", [&] { panel->moveDown(); });
    doing("undo moving", [&] { history->undo(); });
    doing("select all", [&] { list->selectAll(); });
    doing("copy all", [&] { panel->copySelected(); });
    const int count = list->model()->rowCount();
    const int many = std::min(count, 20'000);
    doing("select many", [&] {
        list->selectionModel()->select({list->model()->index(0, 0), list->model()->index(many - 1, 0)},
                                       QItemSelectionModel::ClearAndSelect);
    });
    doing("copy many", [&] { panel->copySelected(); });
    doing("duplicate many", [&] { panel->duplicateSelected(); });
    QCOMPARE(list->model()->rowCount(), count + many);
    doing("undo duplicating", [&] { history->undo(); });
    doing("paste many", [&] { panel->paste(); });
    QCOMPARE(list->model()->rowCount(), count + many);
    doing("undo pasting", [&] { history->undo(); });
    doing("save", [&] {
        for (QAction* action : m_window->findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(QKeySequence::Save)) return action->trigger();
    });
    QVERIFY(!m_window->document().isModified());
    doing("close", [&] { m_window->close(); });
    QTRY_VERIFY(!m_window);
    QCOMPARE(takeLate(), QString());
}

void LargeFilesTest::mapsAreSelected() {
    openLarge(entries(1, 100'000));
    m_late.clear(); // opening is not what is asked here
    auto* table = m_window->findChild<view::MapsPanel*>()->findChild<QTableView*>();
    QCOMPARE(table->model()->rowCount(), 100'000);
    doing("select all", [&] { table->selectAll(); });
    doing("select one", [&] { table->selectRow(50'000); });
    doing("scroll", [&] { table->scrollToBottom(); });
    QCOMPARE(takeLate(), QString());
}

void LargeFilesTest::mapsAreEdited_data() {
    QTest::addColumn<QByteArray>("maps");
    QTest::newRow("1 000") << rows(1'000);
    QTest::newRow("1 000 that overlap") << rows(1'000, ".5 .1 .05 .5 ");
    if (!support::isThorough()) return;
    QTest::newRow("100 that overlap") << rows(100, ".5 .1 .05 .5 ");
    QTest::newRow("50 000") << rows(50'000); // twice as many with a branch as a map of its own
}

void LargeFilesTest::mapsAreEdited() {
    QFETCH(QByteArray, maps);
    openLarge("many {\n" + maps + "}\n");
    const int count = int(maps.count('\n'));
    dragTheCage();
    editMaps(count);
    openDialogs();
    editABranch(count);
    moveEveryMap(count);
    editTheTable(count);
    QCOMPARE(takeLate(), QString());
}

void LargeFilesTest::dragTheCage() {
    auto* canvas = m_window->findChild<view::CanvasView*>();
    QUndoStack* history = m_window->document().undoStack();
    const auto press = [canvas](Qt::Key key) { return [canvas, key] { QTest::keyClick(canvas, key); }; };
    doing("focus", [&] { canvas->setFocus(); });
    doing("take a vertex", press(Qt::Key_Tab));
    doing("nudge", press(Qt::Key_Right));
    doing("nudge again", press(Qt::Key_Up));
    doing("undo", [&] { history->undo(); });
    doing("redo", [&] { history->redo(); });
    const QPoint vertex = canvas->canvas().positionOf({view::CanvasPart::Kind::Vertex, 1}).toPoint();
    doing("press", [&] { QTest::mousePress(canvas->viewport(), Qt::LeftButton, {}, vertex); });
    for (int step = 1; step <= 10; ++step)
        doing("drag", [&] { QTest::mouseMove(canvas->viewport(), vertex + QPoint(3 * step, 2 * step)); });
    // Not within an event of its own, which would begin with the button held.
    QTest::mouseRelease(canvas->viewport(), Qt::LeftButton, {}, vertex + QPoint(30, 20));
    doing("rest", [] {});
    QVERIFY(history->undoText().startsWith(QStringLiteral("Move vertex 2 ")));
}

void LargeFilesTest::editMaps(int count) {
    auto* panel = m_window->findChild<view::MapsPanel*>();
    auto* canvas = m_window->findChild<view::CanvasView*>();
    QAbstractItemModel* model = panel->findChild<QTableView*>()->model();
    QUndoStack* history = m_window->document().undoStack();
    doing("coefficient", [&] { model->setData(model->index(count / 2, view::MapsModel::E), 3.5); });
    doing("undo coefficient", [&] { history->undo(); });
    doing("switch off", [&] {
        model->setData(model->index(7, view::MapsModel::Enabled), Qt::Unchecked, Qt::CheckStateRole);
    });
    doing("fit", [&] { canvas->fit(); });
    doing("zoom", [&] { canvas->navigation().zoomBy(3); });
    doing("bake", [&] { m_window->findChild<view::CagePanel*>()->bake(); });
    doing("undo baking", [&] { history->undo(); });
}

void LargeFilesTest::openDialogs() {
    const auto choose = [this](const char* id) { support::command(*m_window, id)->trigger(); };
    doing("affine invariant form", [&] { choose("affine-invariant-form"); });
    doing("mutate", [&] { choose("mutate"); });
    auto* ring = m_window->findChild<view::VariationRing*>();
    QTRY_VERIFY(!view::PictureTiles::shown(ring->indexFromItem(ring->childItem(0))).pixmap.isNull());
    doing("leave the dialogs", [&] {
        for (auto* dialog : m_window->findChildren<QDialog*>())
            dialog->reject();
    });
}

void LargeFilesTest::editABranch(int count) {
    auto* canvas = m_window->findChild<view::CanvasView*>();
    QUndoStack* history = m_window->document().undoStack();
    const auto press = [canvas](Qt::Key key) { return [canvas, key] { QTest::keyClick(canvas, key); }; };
    doing("branch tool", [&] { canvas->setTool(view::CanvasView::Tool::Branch); });
    doing("choose a branch", [&] {
        canvas->tools().branchTool().choice().choose({count / 2, 1}); // points under the pointer have many
    });
    doing("its own map",
          [&] { canvas->tools().branchTool().choice().setEdit(document::BranchEdit::OwnMap); });
    doing("take the branch", press(Qt::Key_Tab));
    const int before = history->index();
    doing("nudge the branch", press(Qt::Key_Right));
    QCOMPARE(history->index(), before + 1);
    doing("undo the nudge", [&] { history->undo(); });
}

void LargeFilesTest::moveEveryMap(int count) {
    auto* canvas = m_window->findChild<view::CanvasView*>();
    QUndoStack* history = m_window->document().undoStack();
    const auto press = [canvas](Qt::Key key) { return [canvas, key] { QTest::keyClick(canvas, key); }; };
    doing("maps tool", [&] { canvas->setTool(view::CanvasView::Tool::Maps); });
    doing("select every map", [&] { QTest::keyClick(canvas, Qt::Key_A, Qt::ControlModifier); });
    QCOMPARE(canvas->selectedMaps().size(), std::size_t(count));
    doing("zoom out", [&] { canvas->navigation().zoomBy(0.2); });
    const QPointF corner(3, 3), other(43, 33);
    QVERIFY(canvas->canvas().partAt(corner, view::Reach::Mouse).kind == view::CanvasPart::Kind::None);
    const auto mouse = [canvas](QEvent::Type type, const QPointF& at, Qt::MouseButton button,
                                Qt::MouseButtons held) {
        QMouseEvent event(type, at, canvas->viewport()->mapToGlobal(at), button, held, Qt::ShiftModifier);
        QCoreApplication::sendEvent(canvas->viewport(), &event);
    };
    doing("begin a rectangle",
          [&] { mouse(QEvent::MouseButtonPress, corner, Qt::LeftButton, Qt::LeftButton); });
    doing("draw it", [&] { mouse(QEvent::MouseMove, other, Qt::NoButton, Qt::LeftButton); });
    doing("end it", [&] { mouse(QEvent::MouseButtonRelease, other, Qt::LeftButton, Qt::NoButton); });
    QCOMPARE(canvas->selectedMaps().size(), std::size_t(count));
    doing("take them", press(Qt::Key_Tab));
    const int still = history->index();
    doing("move every map", press(Qt::Key_Right));
    QCOMPARE(canvas->selectedMaps().size(), std::size_t(count));
    QCOMPARE(history->index(), still + 1);
    doing("undo moving", [&] { history->undo(); });
    doing("cage tool", [&] { canvas->setTool(view::CanvasView::Tool::Cage); });
}

void LargeFilesTest::editTheTable(int count) {
    auto* panel = m_window->findChild<view::MapsPanel*>();
    QAbstractItemModel* model = panel->findChild<QTableView*>()->model();
    QUndoStack* history = m_window->document().undoStack();
    doing("select all", [&] { panel->findChild<QTableView*>()->selectAll(); });
    doing("copy", [&] { panel->copyMaps(); });
    doing("paste", [&] { panel->pasteMaps(); });
    doing("undo pasting", [&] { history->undo(); });
    doing("duplicate", [&] { panel->duplicateMaps(); });
    doing("undo duplicating", [&] { history->undo(); });
    doing("select none", [&] { panel->findChild<QTableView*>()->clearSelection(); });
    doing("paste more", [&] { panel->pasteMaps(); });
    QCOMPARE(model->rowCount(), 2 * count);
    doing("undo pasting more", [&] { history->undo(); });
    doing("select all again", [&] { panel->findChild<QTableView*>()->selectAll(); });
    doing("remove", [&] { panel->deleteMaps(); });
    doing("undo removing", [&] { history->undo(); });
}

void LargeFilesTest::framesOfManyMapsAreDragged() {
    openLarge(squareSvg(40));
    auto* canvas = m_window->findChild<view::CanvasView*>();
    doing("maps tool", [&] { canvas->setTool(view::CanvasView::Tool::Maps); });
    const QPoint inside = canvas->canvas().positionOf({view::CanvasPart::Kind::Inside, 0, 800}).toPoint();
    doing("press", [&] { QTest::mousePress(canvas->viewport(), Qt::LeftButton, {}, inside); });
    for (int step = 1; step <= 10; ++step)
        doing("drag", [&] { QTest::mouseMove(canvas->viewport(), inside + QPoint(3 * step, 2 * step)); });
    QTest::mouseRelease(canvas->viewport(), Qt::LeftButton, {}, inside + QPoint(30, 20));
    doing("rest", [] {});
    QCOMPARE(m_window->document().undoStack()->count(), 1);
    QCOMPARE(takeLate(), QString());
}

void LargeFilesTest::branchesAreFoundAmongManyMaps() {
    QByteArray text = "overlapping {\n"; // every point has thousands of addresses
    const int side = support::isThorough() ? 100 : 40;
    for (int i = 0; i < side * side; ++i)
        text += ".5 0 0 .5 " + QByteArray::number(i % side / (2. * side)) + ' ' +
                QByteArray::number(i / side / (2. * side)) + " 1\n";
    openLarge(text + "}\n");
    auto* canvas = m_window->findChild<view::CanvasView*>();
    doing("branch tool", [&] { canvas->setTool(view::CanvasView::Tool::Branch); });
    doing("choose a branch", [&] { canvas->tools().branchTool().choice().choose({side * side / 2, 1}); });
    doing("display", [&] { canvas->tools().branchTool().choice().setEdit(document::BranchEdit::Display); });
    doing("take it", [&] { QTest::keyClick(canvas, Qt::Key_Tab); });
    doing("nudge it", [&] { QTest::keyClick(canvas, Qt::Key_Right); });
    QCOMPARE(document::plane(m_window->document().fractal())->moved.size(), std::size_t(1));
    const auto* scene = canvas->findChild<view::CanvasScene*>();
    for (const double across : {0.1, 0.9, 0.3, 0.6}) { // of a square of side 1, above the knobs
        const ifs::Word before = scene->handles().branch();
        const QPoint place = view::pixelOf(canvas->camera(), {0.99 * across, 0.8}).toPoint();
        doing("choose another", [&] { QTest::mousePress(canvas->viewport(), Qt::LeftButton, {}, place); });
        QTest::mouseRelease(canvas->viewport(), Qt::LeftButton, {}, place);
        QVERIFY(scene->handles().branch() != before);
    }
    QCOMPARE(takeLate(), QString());
}

void LargeFilesTest::workIsRecovered() {
    const document::Snapshot snapshot{{}, QStringLiteral("mine"), 7, {}, entries(100'000, 2), {}};
    doing("recover", [&] {
        m_window->openRecovered({m_folder.filePath(QStringLiteral("journal")), snapshot, {}});
    });
    QCOMPARE(m_window->document().file().entries.size(), 100'000);
    QCOMPARE(m_window->document().fractal().name, QStringLiteral("entry7"));
    QVERIFY(m_window->document().isModified());
    QCOMPARE(takeLate(), QString());
}

void LargeFilesTest::aFolderIsBrowsed() {
    const QTemporaryDir folder;
    for (const char* name : {"a.ifs", "b.ifs", "c.ifs"})
        putFile(folder.filePath(QString::fromLatin1(name)), entries(2000, 2));
    auto* panel = m_window->findChild<view::CollectionPanel*>();
    auto* grid = panel->findChild<QListView*>();
    auto* search = panel->findChild<QLineEdit*>();
    QTRY_VERIFY(grid->model()->rowCount() > 0);
    QVERIFY(support::backgroundRests());
    const int before = grid->model()->rowCount();
    doing("add", [&] { panel->addFolder(folder.path()); });
    QTRY_COMPARE(grid->model()->rowCount(), before + 3 * 2001);
    doing("scroll", [&] { grid->verticalScrollBar()->setValue(grid->verticalScrollBar()->maximum() / 2); });
    for (const char* typed : {"e", "en", "entry1", "entry19", ""})
        doing("search", [&] { search->setText(QString::fromLatin1(typed)); });
    doing("remove", [&] { panel->removeFolder(folder.path()); });
    QCOMPARE(grid->model()->rowCount(), before);
    QCOMPARE(takeLate(), QString());
}

// But for those that ask for a file, a printer, or to leave. Every sixth, or all.
void LargeFilesTest::everyCommandIsChosen() {
    openLarge("many {\n" + rows(support::isThorough() ? 50'000 : 10'000) + "}\n");
    const QStringList left{QStringLiteral("Open…"),
                           QStringLiteral("Save As…"),
                           QStringLiteral("Print…"),
                           QStringLiteral("Close"),
                           QStringLiteral("Quit"),
                           QStringLiteral("Revert"),
                           QStringLiteral("New"),
                           QStringLiteral("New Window"),
                           QStringLiteral("About Qt"),
                           QStringLiteral("About Barycage"),
                           QStringLiteral("Save Lesson…"),
                           QStringLiteral("Save Lesson As…"),
                           QStringLiteral("Save a Copy for Other Programs…"),
                           QStringLiteral("Export Web Page…")};
    QList<QPointer<QAction>> commands;
    for (const QMenu* menu : m_window->menuBar()->findChildren<QMenu*>())
        for (QAction* action : menu->actions())
            if (!action->isSeparator() && !action->menu() && !left.contains(action->text().remove(u'&')))
                commands << action;
    QVERIFY(commands.size() > 40);
    int number = 0;
    for (const QPointer<QAction>& command : commands) {
        if (!command || !command->isEnabled()) continue;
        if (number++ % 6 != 0 && !support::isThorough()) continue;
        const QByteArray name = command->text().toUtf8();
        doing(name, [&] { command->trigger(); });
        (void)QTest::qWaitFor([] { return document::backgroundFinishes(0ms); },
                              200); // or longer than we watch
        doing(name + ", left again", [&] {
            for (auto* dialog : m_window->findChildren<QDialog*>())
                dialog->reject();
            QWhatsThis::leaveWhatsThisMode();
        });
    }
    auto* panel = m_window->findChild<view::MapsPanel*>();
    for (const auto rule : {document::WeightRule::Determinant, document::WeightRule::Equal,
                            document::WeightRule::Dimension, document::WeightRule::Normalise})
        doing("weights", [&] { panel->applyWeights(rule); });
    QCOMPARE(takeLate(), QString());
}

BARYCAGE_TEST(LargeFilesTest, support::WatchedApplication);

#include "large_files_test.moc"
