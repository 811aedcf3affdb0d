// SPDX-License-Identifier: MIT
#include "bridges/export_queue.h"
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "dialogs/export/space_export_dialog.h"
#include "document/fractal/fractal.h"
#include "files/exports.h"
#include "io/exports/export_recipe.h"
#include "io/fractint/entry_writer.h"
#include "session/session.h"
#include "session_fixture.h"
#include "space/four_views.h"
#include "space/space_view.h"
#include "stage/stage.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"

#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPointer>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTimer>
#include <QUndoStack>

// Windows that are closed while something is under way in them.
class ClosingWindowsTest : public SessionFixture {
    Q_OBJECT

private slots:
    void aWindowMayGoWhileANameIsTyped();
    void aWindowMayGoInMidDrag_data();
    void aWindowMayGoInMidDrag();
    void theQuestionGoesWithTheLastExport();
    void anExportInADialogIsAskedAbout();
    void whatIsSavedOnTheWayIsOpenedAgain();
    void whoStaysKeepsItsPanels_data();
    void whoStaysKeepsItsPanels();
};

// The field is left when the window goes, and says what it holds to a document that must still be there.
void ClosingWindowsTest::aWindowMayGoWhileANameIsTyped() {
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

void ClosingWindowsTest::aWindowMayGoInMidDrag_data() {
    QTest::addColumn<bool>("isInSpace");
    QTest::addColumn<bool>("areFourShown");
    QTest::addColumn<view::Toolbox::Tool>("tool");
    QTest::addColumn<bool>("pans");
    using Tool = view::Toolbox::Tool;
    for (const auto& [name, tool] :
         {std::pair{"cage", Tool::Cage}, {"maps", Tool::Maps}, {"definition", Tool::DefineTriangle}})
        for (const bool pans : {false, true}) {
            const char* how = pans ? "panning" : "dragging";
            QTest::addRow("plane, %s, %s", name, how) << false << false << tool << pans;
            QTest::addRow("space, %s, %s", name, how) << true << false << tool << pans;
            QTest::addRow("four views, %s, %s", name, how) << true << true << tool << pans;
        }
}

// The views outlive the document and what draws for them.
void ClosingWindowsTest::aWindowMayGoInMidDrag() {
    QFETCH(const bool, isInSpace);
    QFETCH(const bool, areFourShown);
    QFETCH(const view::Toolbox::Tool, tool);
    QFETCH(const bool, pans);
    MainWindow* window = shown(support::testData(QStringLiteral("shapes.ifs")));
    QVERIFY(QTest::qWaitForWindowExposed(window));
    auto* stage = window->findChild<Stage*>();
    if (isInSpace) window->document().edit(QStringLiteral("solid"), pairOfCubes());
    stage->views()->showFour(areFourShown);
    stage->plane()->setTool(tool);
    QWidget* viewport = isInSpace ? stage->space()->viewport() : stage->plane()->viewport();
    QTRY_VERIFY(viewport->isVisible());
    const Qt::MouseButton button = pans ? Qt::MiddleButton : Qt::LeftButton;
    const QPoint from = viewport->rect().center();
    QTest::mousePress(viewport, button, {}, from);
    QMouseEvent move(QEvent::MouseMove, QPointF(from + QPoint(40, 25)),
                     viewport->mapToGlobal(QPointF(from + QPoint(40, 25))), Qt::NoButton, button, {});
    QApplication::sendEvent(viewport, &move);
    window->document().undoStack()->setClean();
    delete window;
    QVERIFY(windows().isEmpty());
}

// Nobody need answer it once nothing is left to do.
void ClosingWindowsTest::theQuestionGoesWithTheLastExport() {
    const QPointer<MainWindow> window = shown(support::testData(QStringLiteral("shapes.ifs")));
    QVERIFY(QTest::qWaitForWindowExposed(window));
    const QTemporaryDir folder;
    io::PixelRecipe recipe; // takes minutes
    recipe.camera.width = 6000;
    recipe.camera.height = 4000;
    recipe.camera = attractor::fitted(recipe.camera, {0, 0}, {1, 0.9});
    recipe.samplesPerPixel = 2000;
    io::ExportTask task;
    task.path = folder.filePath(QStringLiteral("long.png"));
    task.entry = io::writeEntry(document::sierpinskiTriangle());
    task.recipe = recipe;
    view::ExportQueue* queue = exports::queue();
    queue->add(task);
    QCOMPARE(queue->unfinished(), 1);
    int looks = 0;
    QTimer watch;
    connect(&watch, &QTimer::timeout, this, [&] {
        auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!question) return;
        if (++looks == 1) queue->cancel(queue->exports().front().id);
        if (looks == 100) question->reject();
    });
    watch.start(50);
    QVERIFY(window->close());
    QVERIFY(looks > 0 && looks < 100);
}

void ClosingWindowsTest::anExportInADialogIsAskedAbout() {
    const QPointer<MainWindow> window = shown(support::testData(QStringLiteral("shapes.ifs")));
    QVERIFY(QTest::qWaitForWindowExposed(window));
    document::System3 gasket;
    for (const ifs::Vector<3>& corner : {ifs::Vector<3>(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
        ifs::append(gasket, ifs::AffineMap<3>{ifs::Matrix<3>::Identity() / 2, corner / 2});
    document::Fractal solid;
    solid.shape = document::Shape<3>{gasket};
    window->document().edit(QStringLiteral("solid"), solid);
    window->document().undoStack()->setClean();
    const QTemporaryDir folder;
    attractor::OrbitCamera camera;
    camera.size = {160, 120};
    view::SpaceExportDialog dialog(&window->document(), camera, window);
    dialog.setFormat(io::MeshFormat::Stl);
    dialog.show();
    for (auto* box : dialog.findChildren<QSpinBox*>())
        if (box->minimum() == 8) box->setValue(500);           // the resolution
    dialog.exportTo(folder.filePath(QStringLiteral("a.stl"))); // takes seconds
    const char* answer = "continue";
    int questions = 0;
    QTimer watch;
    connect(&watch, &QTimer::timeout, this, [&] {
        auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!question) return;
        ++questions;
        support::button(*question, answer)->click();
    });
    watch.start(20);
    QVERIFY(!window->close());
    QCOMPARE(questions, 1);
    answer = "stop";
    QVERIFY(window->close());
    QCOMPARE(questions, 2);
}

void ClosingWindowsTest::whatIsSavedOnTheWayIsOpenedAgain() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("new.ifs"));
    MainWindow* window = shown({});
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->document().edit(QStringLiteral("solid"), pairOfCubes());
    QTimer answering;
    connect(&answering, &QTimer::timeout, this, [&path] {
        QWidget* dialog = QApplication::activeModalWidget();
        if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
            files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
            QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
        } else if (auto* question = qobject_cast<QMessageBox*>(dialog)) {
            // That of the folder, which may not be read yet, goes away again.
            QAbstractButton* save = question->button(QMessageBox::Save);
            save ? save->click() : question->reject();
        }
    });
    answering.start(50);
    session::restart();
    QVERIFY(session::filesToReopen());
    QCOMPARE(*session::filesToReopen(), QStringList{path});
}

void ClosingWindowsTest::whoStaysKeepsItsPanels_data() {
    QTest::addColumn<bool>("isChangedFirst");
    QTest::newRow("the last one has changes") << false;
    QTest::newRow("the first one has changes") << true;
}

// A panel that floats is a window of its own. Nothing is closed before all have been asked, and nobody twice.
void ClosingWindowsTest::whoStaysKeepsItsPanels() {
    QFETCH(bool, isChangedFirst);
    MainWindow* first = shown(support::testData(QStringLiteral("dos.ifs")));
    MainWindow* last = shown(support::testData(QStringLiteral("shapes.ifs")));
    MainWindow* saved = isChangedFirst ? last : first;
    MainWindow* changed = isChangedFirst ? first : last;
    QVERIFY(QTest::qWaitForWindowExposed(changed));
    QList<QDockWidget*> panels;
    for (MainWindow* window : {saved, changed}) {
        panels << window->findChild<QDockWidget*>(QStringLiteral("entries"));
        panels.last()->setFloating(true);
        panels.last()->show();
    }
    changed->document().edit(QStringLiteral("solid"), pairOfCubes());
    int asked = 0;
    QMessageBox::StandardButton press = QMessageBox::Cancel;
    QTimer answer;
    connect(&answer, &QTimer::timeout, this, [&] {
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* box = qobject_cast<QMessageBox*>(widget); box && box->isVisible()) {
                ++asked;
                box->button(press)->click();
            }
    });
    answer.start(20);
    session::quit();
    QCOMPARE(asked, 1);
    QVERIFY(saved->isVisible() && changed->isVisible());
    for (const QDockWidget* panel : panels)
        QVERIFY(panel->isVisible() && panel->isFloating());
    changed->close(); // asks anew
    QCOMPARE(asked, 2);
    QVERIFY(changed->isVisible());
    press = QMessageBox::Discard;
    session::quit();
    QCOMPARE(asked, 3); // once
    QVERIFY(!saved->isVisible() && !changed->isVisible());
}

BARYCAGE_TEST(ClosingWindowsTest, QApplication);
#include "closing_windows_test.moc"
