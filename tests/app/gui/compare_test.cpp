// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "bars/branch_bar.h"
#include "bridges/render_bridge.h"
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "compare/compare_pane.h"
#include "document/fractal/fractal_geometry.h"
#include "space/space_view.h"
#include "stage/stage.h"
#include "support/choose.h"
#include "support/commands.h"
#include "support/events.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <algorithm>

using namespace Qt::StringLiterals;

// Another entry of the file beside the current one: both are edited in one history, and look at the same
// place on request.
class CompareTest : public WindowFixture {
    Q_OBJECT

private slots:
    void showsAndHides();
    void bothAreDraggedInOneHistory();
    void viewsAreLinkedOnRequest();
    void entriesChangePlaces();
    void rotationsGoWithTheEntries();
    void undoLeavesThePlaces();
    void entriesComeAndGo();
    void solidsAreCompared();
    void branchesOfBothAreDragged();
    void waysOfTheWindowHoldForBoth();
    void undoKeepsTheBranchInBoth_data();
    void undoKeepsTheBranchInBoth();

private:
    document::Document& document() { return m_window->document(); }
    view::CanvasView* canvas() const { return m_window->findChild<Stage*>()->plane(); }
    view::ComparePane* pane() const { return m_window->findChild<view::ComparePane*>(); }
    QComboBox* entries() const { return pane()->findChild<QComboBox*>(); }
    QAbstractButton* button(const char* name) const { return support::button(*pane(), name); }
    void toggle() { QTest::keyClick(canvas(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier); }
    document::EntryId idOf(const QString& name) {
        for (const auto& entry : document().file().entries)
            if (entry.fractal->name == name) return entry.id;
        return document::EntryId::None;
    }
    QString shown() { // beside
        const qsizetype index = document::indexOf(document().file(), pane()->entry());
        return index < 0 ? QString() : document().file().entries[index].fractal->name;
    }
    void open(const QByteArray& bytes) {
        const QString path = m_folder.filePath(u"a.ifs"_s);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        QVERIFY(m_window->openPath(path));
    }

    QTemporaryDir m_folder;
};

void CompareTest::showsAndHides() {
    const int width = canvas()->width();
    QVERIFY(!pane()->isVisible());
    toggle();
    QTRY_VERIFY(pane()->isVisible() && pane()->plane()->isVisible());
    QCOMPARE(shown(), u"flower"_s);
    QCOMPARE(entries()->count(), 1);
    QTRY_VERIFY(std::abs(canvas()->width() - pane()->width()) < 20);
    QTRY_VERIFY(!pane()->plane()->picture().isNull());
    QVERIFY(pane()->plane()->picture() != canvas()->picture());
    button("close")->click();
    QTRY_COMPARE(canvas()->width(), width);
    toggle(); // the button has told the menu
    QTRY_VERIFY(pane()->isVisible());
    QCOMPARE(shown(), u"flower"_s);
}

void CompareTest::bothAreDraggedInOneHistory() {
    toggle();
    QTRY_VERIFY(pane()->plane()->isVisible());
    const document::FractalFile before = document().file();
    view::CanvasView* other = pane()->plane();
    const auto drag = [this](view::CanvasView* on) {
        const auto& cage = on->canvas().handles().cage();
        const QPoint corner = on->canvas().positionOf({view::CanvasPart::Kind::Vertex, 0}).toPoint();
        QVERIFY(cage);
        QTest::mousePress(on->viewport(), Qt::LeftButton, {}, corner);
        QTest::mouseMove(on->viewport(), corner + QPoint(10, 5));
        QTest::mouseMove(on->viewport(), corner + QPoint(25, 15));
        QTest::mouseRelease(on->viewport(), Qt::LeftButton, {}, corner + QPoint(25, 15));
    };
    drag(canvas());
    QCOMPARE(document().undoStack()->count(), 1);
    drag(other);
    QCOMPARE(document().undoStack()->count(), 2);
    QCOMPARE(document().fractal().name, u"maple"_s);
    for (const char* name : {"maple", "flower"})
        QVERIFY(!(*document()
                       .file()
                       .entries[document::indexOf(document().file(), idOf(QLatin1String(name)))]
                       .fractal ==
                  *before.entries[document::indexOf(before, idOf(QLatin1String(name)))].fractal));
    document().undoStack()->undo();
    document().undoStack()->undo();
    QVERIFY(document().file() == before);
    QCOMPARE(other->canvas().handles().cage()->current, other->canvas().handles().cage()->rest);
    // The tools of the window serve both.
    canvas()->setTool(view::CanvasView::Tool::Maps);
    QCOMPARE(other->tool(), view::CanvasView::Tool::Maps);
    canvas()->options().setOverlaysVisible(false);
    QVERIFY(!other->options().overlaysVisible());
    canvas()->options().setOverlaysVisible(true);
    document().undoStack()->setClean();
}

void CompareTest::viewsAreLinkedOnRequest() {
    toggle();
    QTRY_VERIFY(pane()->plane()->isVisible());
    view::CanvasView* other = pane()->plane();
    const auto areAlike = [&] {
        return canvas()->camera().centre == other->camera().centre &&
               canvas()->camera().pixelsPerUnit == other->camera().pixelsPerUnit;
    };
    canvas()->navigation().zoomBy(2);
    QVERIFY(!areAlike());
    const attractor::Camera before = canvas()->camera();
    pane()->setViewsLinked(true);
    QVERIFY(areAlike());
    QCOMPARE(canvas()->camera(), before); // the other one comes to it
    canvas()->navigation().zoomAt({10, 20}, 3);
    QVERIFY(areAlike());
    other->navigation().pan({40, -30});
    QVERIFY(areAlike());
    canvas()->navigation().setYAxis(attractor::YAxis::Down);
    QCOMPARE(other->camera().yAxis, attractor::YAxis::Down);
    canvas()->navigation().setYAxis(attractor::YAxis::Up);
    canvas()->fit();
    QTRY_VERIFY(areAlike());
    pane()->setViewsLinked(false);
    other->navigation().zoomBy(2);
    QVERIFY(!areAlike());
}

void CompareTest::entriesChangePlaces() {
    open("a {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\nb {\n .4 0 0 .4 0 0 1\n .4 0 0 .4 9 0 1\n}\n"
         "c {\n .3 0 0 .3 0 0 1\n .3 0 0 .3 0 7 1\n}\n");
    toggle();
    QTRY_VERIFY(pane()->isVisible());
    QCOMPARE(shown(), u"b"_s);
    document().setCurrent(idOf(u"b"_s));
    QCOMPARE(shown(), u"a"_s);
    document().setCurrent(idOf(u"c"_s));
    QCOMPARE(shown(), u"a"_s);
    // Linked, another entry comes to the view of the window and not the other way round.
    pane()->setViewsLinked(true);
    canvas()->navigation().zoomBy(2);
    const attractor::Camera camera = canvas()->camera();
    support::choose(entries(), idOf(u"b"_s));
    QCOMPARE(shown(), u"b"_s);
    support::handleEvents();
    for (const view::CanvasView* each : {canvas(), pane()->plane()}) {
        QCOMPARE(each->camera().centre, camera.centre);
        QCOMPARE(each->camera().pixelsPerUnit, camera.pixelsPerUnit);
    }
}

void CompareTest::rotationsGoWithTheEntries() {
    open("a {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\nb {\n .4 0 0 .4 0 0 1\n .4 0 0 .4 9 0 1\n}\n"
         "c {\n .3 0 0 .3 0 0 1\n .3 0 0 .3 0 7 1\n}\n");
    toggle();
    QTRY_VERIFY(pane()->isVisible() && pane()->plane()->isVisible());
    const auto rotations = [this] {
        return QList<double>{canvas()->navigation().rotation(), pane()->plane()->navigation().rotation()};
    };
    const auto showBeside = [this](const QString& name) { support::choose(entries(), idOf(name)); };
    canvas()->navigation().rotateBy(30);
    pane()->plane()->navigation().rotateBy(-45);
    document().setCurrent(idOf(u"b"_s)); // they change places
    QCOMPARE(shown(), u"a"_s);
    QCOMPARE(rotations(), QList<double>({-45, 30}));
    showBeside(u"c"_s);
    QCOMPARE(rotations(), QList<double>({-45, 0}));
    showBeside(u"a"_s);
    QCOMPARE(rotations(), QList<double>({-45, 30}));
    support::command(*m_window, "presentation")->trigger();
    document().setCurrent(idOf(u"a"_s));
    QCOMPARE(rotations(), QList<double>({30, -45}));
    document().setCurrent(idOf(u"c"_s)); // in place of a
    QCOMPARE(canvas()->navigation().rotation(), 0.0);
    QTest::keyClick(canvas(), Qt::Key_Escape);
    // Views that are linked turn together.
    pane()->setViewsLinked(true);
    canvas()->navigation().rotateBy(15);
    document().setCurrent(idOf(u"a"_s));
    QCOMPARE(rotations(), QList<double>({15, 15}));
}

// Both are in sight: nothing has to change places to show what is undone.
void CompareTest::undoLeavesThePlaces() {
    open("a {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\nb {\n .4 0 0 .4 0 0 1\n .4 0 0 .4 9 0 1\n}\n");
    toggle();
    QTRY_VERIFY(pane()->isVisible());
    const document::Fractal before = document().entryFractal();
    document::Fractal after = before;
    document::plane(after)->system.maps[0].map.translation.x() = 0.25;
    document().edit(u"edit"_s, after);
    document().setCurrent(idOf(u"b"_s));
    QCOMPARE(shown(), u"a"_s);
    document().undoStack()->undo();
    QCOMPARE(document().fractal().name, u"b"_s);
    QCOMPARE(shown(), u"a"_s);
    const auto systemBeside = [&] { return document::plane(*document().file().entries[0].fractal)->system; };
    QVERIFY(systemBeside() == document::plane(before)->system);
    document().undoStack()->redo();
    QCOMPARE(document().fractal().name, u"b"_s);
    QVERIFY(systemBeside() == document::plane(after)->system);
    toggle(); // alone, the entry that is undone is shown
    QTRY_VERIFY(!pane()->isVisible());
    document().undoStack()->undo();
    QCOMPARE(document().fractal().name, u"a"_s);
}

void CompareTest::entriesComeAndGo() {
    open("a {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\n");
    toggle();
    QTRY_VERIFY(pane()->isVisible());
    QCOMPARE(pane()->entry(), document::EntryId::None);
    const auto* views = pane()->findChild<QStackedWidget*>();
    QVERIFY(qobject_cast<QLabel*>(views->currentWidget())); // which says so
    QVERIFY(!entries()->isEnabled() && !button("link-views")->isEnabled());
    document::FractalFile file = document().file();
    document::Entry copy = file.entries.first();
    document::Fractal renamed = *copy.fractal;
    renamed.name = u"a2"_s;
    copy.id = document::freshId(file);
    copy.fractal = std::make_shared<const document::Fractal>(renamed);
    file.entries << copy;
    document().editFile(u"Add"_s, file, file.entries.first().id);
    QCOMPARE(shown(), u"a2"_s);
    QVERIFY(button("link-views")->isEnabled());
    document().undoStack()->undo();
    QCOMPARE(pane()->entry(), document::EntryId::None);
    QVERIFY(qobject_cast<QLabel*>(views->currentWidget()));
    document().undoStack()->setClean();
    // One that cannot be read is shown as such.
    open("a {\n .5 0 0 .5 0 0 1\n}\nbroken {\n 1 2\n}\n");
    QTRY_COMPARE(shown(), u"broken"_s);
    QVERIFY(!button("link-views")->isEnabled());
    QVERIFY(!pane()->plane()->note().isEmpty());
}

void CompareTest::solidsAreCompared() {
    open("a (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n .5 0 0 0 .5 0 0 0 .5 .5 .5 .5 1\n}\n"
         "b (3D) {\n .4 0 0 0 .4 0 0 0 .4 0 0 0 1\n .4 0 0 0 .4 0 0 0 .4 .6 0 .6 1\n}\n"
         "flat {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\n");
    QTest::keyClick(m_window.get(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(pane()->isVisible() && pane()->space()->isVisible());
    QCOMPARE(shown(), u"b"_s);
    view::SpaceNavigation& own = m_window->findChild<Stage*>()->space()->navigation();
    view::SpaceNavigation& other = pane()->space()->navigation();
    own.zoomAt(own.middle(), 2);
    pane()->setViewsLinked(true);
    const auto areAlike = [&] {
        return own.camera().target == other.camera().target &&
               own.camera().orientation.coeffs() == other.camera().orientation.coeffs() &&
               std::abs(attractor::pixelsPerUnit(own.camera()) / attractor::pixelsPerUnit(other.camera()) -
                        1) < 1e-9;
    };
    QVERIFY(areAlike());
    other.orbit(other.camera(), other.camera().target, 30, 10);
    QVERIFY(areAlike());
    // A solid and a fractal of the plane have no view in common.
    pane()->setEntry(idOf(u"flat"_s));
    QVERIFY(pane()->plane()->isVisible() && !button("link-views")->isEnabled());
    const attractor::OrbitCamera before = own.camera();
    pane()->plane()->navigation().zoomBy(2);
    QVERIFY(own.camera() == before);
    document().setCurrent(idOf(u"flat"_s));
    QTRY_VERIFY(pane()->space()->isVisible());
}

// What the bar says of branches holds for both canvases.
void CompareTest::branchesOfBothAreDragged() {
    QByteArray cube;
    for (int corner = 0; corner < 8; ++corner)
        cube += u" .5 0 0 0 .5 0 0 0 .5 %1 %2 %3 1\n"_s.arg((corner & 1) / 2.0)
                    .arg((corner >> 1 & 1) / 2.0)
                    .arg((corner >> 2) / 2.0)
                    .toLatin1();
    open("a (3D) {\n" + cube + "}\nb (3D) {\n" + cube + "}\n");
    QTest::keyClick(m_window.get(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(pane()->isVisible() && pane()->space()->isVisible());
    canvas()->setTool(view::CanvasView::Tool::Branch);
    const view::BranchChoice& choice = pane()->plane()->tools().branchTool().choice();
    canvas()->tools().branchTool().choice().setDepth(3);
    QCOMPARE(choice.depth(), 3);
    canvas()->tools().branchTool().choice().setEdit(document::BranchEdit::LastMap);
    QVERIFY(choice.edit() == document::BranchEdit::LastMap);
    view::SpaceView* other = pane()->space();
    const ifs::Vector<3> face(1, 0.6, 0.3); // in the eighth at (1, 1, 0), and of that at (1, 0.2, 0.6)
    const auto pixel = [&] {
        return view::toPoint(toScreen(other->navigation().camera(), face).pixel).toPoint();
    };
    QTRY_VERIFY(other->navigation().pointNear(pixel()));
    QTest::mouseClick(other->viewport(), Qt::LeftButton, {}, pixel());
    QCOMPARE(choice.branch().size(), std::size_t(3));
    QCOMPARE(choice.branch()[0], 3);
    QVERIFY(canvas()->tools().branchTool().choice().branch().empty());
    QCOMPARE(other->mapItem().count(), std::size_t(5));
    const auto* bar = m_window->findChild<view::BranchBar*>();
    const auto isNamed = [&](const QString& name) {
        const QList<QLabel*> labels = bar->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text().contains(name); });
    };
    QVERIFY(isNamed(u"branch <b>4 6"_s));
    const document::Fractal before = *document().file().entries[1].fractal;
    const QPoint corner = other->mapItem().handle(2).toPoint();
    QTest::mousePress(other->viewport(), Qt::LeftButton, {}, corner);
    QTest::mouseMove(other->viewport(), corner + QPoint(9, 9));
    QTest::mouseRelease(other->viewport(), Qt::LeftButton, {}, corner + QPoint(9, 9));
    QCOMPARE(document().undoStack()->count(), 1);
    QVERIFY(!(*document().file().entries[1].fractal == before));
    document().undoStack()->undo();
    QVERIFY(*document().file().entries[1].fractal == before);
    // Put Back is about the same entry.
    support::choose(bar->edit(), document::BranchEdit::Display);
    QTRY_VERIFY(other->navigation().pointNear(pixel()));
    QTest::mouseClick(other->viewport(), Qt::LeftButton, {}, pixel());
    QCOMPARE(choice.branch().size(), std::size_t(3));
    QTest::mousePress(other->viewport(), Qt::LeftButton, {}, corner);
    QTest::mouseMove(other->viewport(), corner + QPoint(9, 9));
    QTest::mouseRelease(other->viewport(), Qt::LeftButton, {}, corner + QPoint(9, 9));
    QCOMPARE(document::space(*document().file().entries[1].fractal)->moved.size(), std::size_t(1));
    QVERIFY(bar->putBackButton()->isVisible());
    bar->putBackButton()->click();
    QVERIFY(*document().file().entries[1].fractal == before);
    QTest::keyClick(other, Qt::Key_Escape);
    QVERIFY(choice.branch().empty() && isNamed(u"no branch selected"_s));
}

// Which axis is up, and whether a drag of maps may lose the attractor, chosen before or while they are
// compared.
void CompareTest::waysOfTheWindowHoldForBoth() {
    const QByteArray solid = " (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n .5 0 0 0 .5 0 0 0 .5 .5 .5 .5 1\n"
                             " .5 0 0 0 .5 0 0 0 .5 .5 0 0 1\n}\n";
    open("a" + solid + "b" + solid);
    const auto choose = [this](const char* id) { support::command(*m_window, id)->trigger(); };
    choose("z-up");
    QTest::keyClick(m_window.get(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(pane()->isVisible() && pane()->space()->isVisible());
    view::SpaceView* own = m_window->findChild<Stage*>()->space();
    view::SpaceView* other = pane()->space();
    QCOMPARE(other->navigation().upAxis(), attractor::UpAxis::Z);
    pane()->setViewsLinked(true);
    choose("z-up");
    QCOMPARE(other->navigation().upAxis(), attractor::UpAxis::Y);
    const auto turned = own->navigation().camera().orientation.coeffs();
    QVERIFY(other->navigation().camera().orientation.coeffs() == turned);
    other->navigation().orbit(other->navigation().camera(), other->navigation().camera().target, 30, 10);
    QVERIFY(own->navigation().camera().orientation.coeffs() ==
            other->navigation().camera().orientation.coeffs());
    for (const std::uint64_t quality : {50'000'000U, 800'000'000U}) {
        view::Preferences preferences;
        preferences.quality = quality;
        m_window->adopt(preferences);
        for (const auto* render : m_window->findChildren<view::RenderBridge*>())
            QCOMPARE(render->quality(), quality);
        QCOMPARE(pane()->findChildren<view::RenderBridge*>().size(), 1);
    }
    // The corner of a map goes as far as it is pulled where that is allowed.
    canvas()->setTool(view::CanvasView::Tool::Maps);
    QTRY_COMPARE(other->mapItem().count(), std::size_t(5));
    const auto isStopped = [&] {
        const QPoint middle = other->mapItem().handle(4).toPoint();
        const QPoint corner = other->mapItem().handle(0).toPoint();
        const QPoint far = middle + 6 * (corner - middle);
        QTest::mousePress(other->viewport(), Qt::LeftButton, Qt::AltModifier, corner);
        QMouseEvent move(QEvent::MouseMove, far, other->viewport()->mapToGlobal(far), Qt::NoButton,
                         Qt::LeftButton, Qt::AltModifier);
        QCoreApplication::sendEvent(other->viewport(), &move);
        const bool stopped = other->note().startsWith(u"Stopped"_s);
        QTest::keyClick(other, Qt::Key_Escape);
        QTest::mouseRelease(other->viewport(), Qt::LeftButton, {}, corner);
        return stopped;
    };
    QVERIFY(isStopped());
    choose("allow-systems-without-an-attractor");
    QVERIFY(!isStopped());
    choose("allow-systems-without-an-attractor");
    QVERIFY(isStopped());
    QCOMPARE(document().undoStack()->count(), 0);
}

void CompareTest::undoKeepsTheBranchInBoth_data() {
    QTest::addColumn<bool>("isSolid");
    QTest::addColumn<bool>("isBeside");
    for (const bool isSolid : {false, true})
        for (const bool isBeside : {false, true})
            QTest::addRow("%s, %s", isSolid ? "space" : "plane", isBeside ? "beside" : "own")
                << isSolid << isBeside;
}

// A branch that became a map of its own by a drag is the branch again, and the map again.
void CompareTest::undoKeepsTheBranchInBoth() {
    QFETCH(const bool, isSolid);
    QFETCH(const bool, isBeside);
    const QByteArray flat = " {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n .5 0 0 .5 0 .5 1\n}\n";
    const QByteArray solid = " (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n .5 0 0 0 .5 0 0 0 .5 .5 0 0 1\n"
                             " .5 0 0 0 .5 0 0 0 .5 0 .5 0 1\n .5 0 0 0 .5 0 0 0 .5 0 0 .5 1\n}\n";
    const QByteArray system = isSolid ? solid : flat;
    open("a" + system + "b" + system);
    toggle();
    QTRY_VERIFY(pane()->isVisible());
    canvas()->setTool(view::CanvasView::Tool::Branch);
    view::CanvasView* plane = isBeside ? pane()->plane() : canvas();
    view::SpaceView* space = isBeside ? pane()->space() : m_window->findChild<Stage*>()->space();
    view::BranchChoice& choice = plane->tools().branchTool().choice();
    const ifs::Word branch{1, 2};
    choice.choose(branch);
    const auto drag = [&] {
        const QPoint corner =
            isSolid ? space->mapItem().handle(1).toPoint()
                    : plane->canvas().positionOf({view::CanvasPart::Kind::Vertex, 1, 0}).toPoint();
        QWidget* viewport = isSolid ? space->viewport() : plane->viewport();
        QTest::mousePress(viewport, Qt::LeftButton, {}, corner);
        QTest::mouseMove(viewport, corner + QPoint(4, 4));
        QTest::mouseMove(viewport, corner + QPoint(9, 9));
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, corner + QPoint(9, 9));
    };
    if (isSolid) QTRY_COMPARE(space->mapItem().count(), std::size_t(5));
    drag();
    QCOMPARE(document().undoStack()->count(), 1);
    QCOMPARE(choice.branch(), ifs::Word{0});
    drag();
    QCOMPARE(document().undoStack()->count(), 2);
    for (int round = 0; round < 2; ++round) {
        document().undoStack()->undo();
        QCOMPARE(choice.branch(), ifs::Word{0});
        document().undoStack()->undo();
        QCOMPARE(choice.branch(), branch);
        document().undoStack()->redo();
        QCOMPARE(choice.branch(), ifs::Word{0});
        document().undoStack()->redo();
        QCOMPARE(choice.branch(), ifs::Word{0});
    }
    document().undoStack()->setClean();
}

BARYCAGE_TEST(CompareTest, QApplication);
#include "compare_test.moc"
