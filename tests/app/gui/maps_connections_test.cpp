// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "bars/branch_bar.h"
#include "bars/tool_options_bar.h"
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "desktop/clipboard.h"
#include "document/document.h"
#include "document/edits/maps/map_locks.h"
#include "document/fractal/space_geometry.h"
#include "document/maps/space_map_handles.h"
#include "panels/maps/maps_panel.h"
#include "space/four_views.h"
#include "space/space_maps.h"
#include "stage/stage.h"
#include "support/commands.h"
#include "support/named_test.h"

#include <QAction>
#include <QClipboard>
#include <QLineF>
#include <QSlider>
#include <QTableView>
#include <QTest>

#include <algorithm>
#include <array>

// The table of maps and the window into space have one selection.
class MapsConnectionsTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theCanvasHoldsTheSelectedRow();
    void theTableSelectsTheHeldMap();
    void nothingIsHeldWithoutASelection();
    void weaveSwingsAllSelectedRows();
    void deletedAndDuplicatedMapsStayInStep();
    void clicksSelectMoreMaps();
    void selectedMapsMoveTogether();
    void fourViewsHoldTheSame();
    void nothingIsOfferedSideBySide();
    void copyAndPasteAreOfMaps();

private:
    using Rows = std::vector<int>;
    document::Document& document() { return m_window->document(); }
    Stage* stage() const { return m_window->findChild<Stage*>(); }
    view::MapsPanel* panel() const { return m_window->findChild<view::MapsPanel*>(); }
    std::size_t held() const { return stage()->space()->heldMap().value_or(99); }
    Rows rows() const { return panel()->model()->rowsOf(panel()->selectedMaps()); }
    void press(view::SpaceView* view, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const {
        QTest::keyClick(view, key, modifiers);
    }
    void showCube() {
        document::Fractal fractal;
        fractal.name = QStringLiteral("cube");
        document::Shape<3> cube;
        for (int corner = 0; corner < 8; ++corner)
            ifs::append<3>(cube.system, {0.5 * ifs::Matrix<3>::Identity(),
                                         ifs::Vector<3>((corner & 1) / 2.0, (corner >> 1 & 1) / 2.0,
                                                        (corner >> 2) / 2.0)});
        fractal.shape = cube;
        document().setFile(document::fileOf(fractal));
        stage()->plane()->setTool(view::CanvasView::Tool::Maps);
        QVERIFY(stage()->showsSpace());
        stage()->takeFocus();
    }
    void choose(const char* id) { support::command(*m_window, id)->trigger(); }
};

void MapsConnectionsTest::theCanvasHoldsTheSelectedRow() {
    showCube();
    QCOMPARE(held(), std::size_t(0));
    panel()->table()->selectRow(5);
    QCOMPARE(held(), std::size_t(5));
    // Selected while another tool is in use, it is held as soon as maps are.
    stage()->plane()->setTool(view::CanvasView::Tool::Cage);
    panel()->table()->selectRow(2);
    stage()->plane()->setTool(view::CanvasView::Tool::Maps);
    QCOMPARE(held(), std::size_t(2));
}

void MapsConnectionsTest::theTableSelectsTheHeldMap() {
    showCube();
    press(stage()->space(), Qt::Key_3, Qt::AltModifier);
    QCOMPARE(held(), std::size_t(2));
    QCOMPARE(rows(), Rows{2});
    QCOMPARE(panel()->table()->currentIndex().row(), 2);
}

void MapsConnectionsTest::nothingIsHeldWithoutASelection() {
    showCube();
    view::SpaceView* space = stage()->space();
    QTRY_COMPARE(space->mapItem().count(), std::size_t(5));
    stage()->views()->showFour(true);
    panel()->table()->clearSelection();
    QVERIFY(!space->heldMap());
    for (const view::SpaceView* other : stage()->views()->others())
        QVERIFY(!other->heldMap());
    QCOMPARE(space->mapItem().count(), std::size_t(0)); // no handles
    QVERIFY(!m_window->findChild<view::BranchBar*>()->swing()->isEnabled());
    press(space, Qt::Key_Delete);
    QCOMPARE(panel()->model()->rowCount(), 8);
    stage()->views()->showFour(false);
    QVERIFY(!space->heldMap());
    press(space, Qt::Key_4, Qt::AltModifier);
    QCOMPARE(held(), std::size_t(3));
    QCOMPARE(rows(), Rows{3});
    panel()->table()->clearSelection();
    press(space, Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(rows().size(), std::size_t(8));
}

void MapsConnectionsTest::weaveSwingsAllSelectedRows() {
    showCube();
    auto* swing = m_window->findChild<view::BranchBar*>()->swing();
    const document::Fractal before = document().fractal();
    const auto swungBy = [&](int degrees) {
        swing->setSliderDown(true);
        for (int way = 1; way <= degrees; ++way)
            swing->setValue(way); // the table follows each
        swing->setSliderDown(false);
        Rows swung;
        for (std::size_t i = 0; i < 8; ++i)
            if (document::system3(document().fractal())->maps[i].map !=
                document::system3(before)->maps[i].map)
                swung.push_back(int(i));
        return swung;
    };
    panel()->selectMaps({panel()->model()->idAt(2), panel()->model()->idAt(5)});
    QCOMPARE(swungBy(8), (Rows{2, 5}));
    QCOMPARE(document().undoStack()->count(), 1);
    QCOMPARE(rows(), (Rows{2, 5}));
    document().undoStack()->undo();
    QVERIFY(document().fractal() == before);
    press(stage()->space(), Qt::Key_3, Qt::AltModifier); // one alone
    QCOMPARE(swungBy(8), Rows{2});
    document().undoStack()->undo();
}

void MapsConnectionsTest::deletedAndDuplicatedMapsStayInStep() {
    showCube();
    panel()->table()->selectRow(5);
    const ifs::MapId next = panel()->model()->idAt(6);
    press(stage()->space(), Qt::Key_Delete);
    QCOMPARE(panel()->model()->rowCount(), 7);
    QCOMPARE(held(), std::size_t(5));
    QVERIFY(panel()->selectedMaps() == std::vector{next});
    press(stage()->space(), Qt::Key_Insert);
    QCOMPARE(panel()->model()->rowCount(), 8);
    QCOMPARE(held(), std::size_t(6));
    QCOMPARE(rows(), Rows{6});
}

// With Shift; the selected maps are deleted and duplicated together, as in the plane.
void MapsConnectionsTest::clicksSelectMoreMaps() {
    showCube();
    view::SpaceView* space = stage()->space();
    QTRY_COMPARE(space->mapItem().count(), std::size_t(5)); // laid out
    const auto click = [&](std::size_t map, Qt::KeyboardModifiers modifiers) {
        const auto cage = *document::knownSpaceCage(document().fractal());
        const auto handles = document::SpaceMapHandles(document().sharedFractal(), cage);
        // The corner that no other map has nearby.
        const auto at = [&](std::size_t k, std::size_t corner) {
            return view::toPoint(
                attractor::toScreen(space->navigation().camera(), handles.corners(k)[corner]).pixel);
        };
        std::size_t best = 0;
        double farthest = -1;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            double nearest = 1e9;
            for (std::size_t k = 0; k < handles.count(); ++k)
                for (std::size_t other = 0; k != map && other < 4; ++other)
                    nearest = std::min(nearest, QLineF(at(k, other), at(map, corner)).length());
            if (nearest > farthest) best = corner;
            farthest = std::max(farthest, nearest);
        }
        QVERIFY(farthest > 14);
        QTest::mouseClick(space->viewport(), Qt::LeftButton, modifiers, at(map, best).toPoint());
    };
    const auto steps = [this] { return document().undoStack()->count(); };
    panel()->table()->selectRow(2);
    const auto count = [this] { return panel()->model()->rowCount(); };
    click(7, Qt::NoModifier);
    QCOMPARE(rows(), Rows{7});
    click(3, Qt::ShiftModifier);
    QCOMPARE(rows(), (Rows{3, 7}));
    QCOMPARE(held(), std::size_t(3));
    QCOMPARE(panel()->table()->currentIndex().row(), 3);
    click(5, Qt::ShiftModifier);
    QCOMPARE(rows(), (Rows{3, 5, 7}));
    click(7, Qt::ShiftModifier); // and not any more
    QCOMPARE(rows(), (Rows{3, 5}));
    click(3, Qt::NoModifier); // holds another of them
    QCOMPARE(held(), std::size_t(3));
    QCOMPARE(rows(), (Rows{3, 5}));
    const int before = steps();
    press(space, Qt::Key_Insert);
    QCOMPARE(count(), 10);
    QCOMPARE(steps(), before + 1);
    QCOMPARE(rows().size(), std::size_t(2));
    press(space, Qt::Key_Delete); // the copies
    QCOMPARE(count(), 8);
    QCOMPARE(steps(), before + 2);
    click(1, Qt::NoModifier);
    QCOMPARE(rows(), Rows{1});
    press(space, Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(rows().size(), std::size_t(8));
    QCOMPARE(held(), std::size_t(1));
}

// Locked ones stay, and a corner is only the held map's.
void MapsConnectionsTest::selectedMapsMoveTogether() {
    showCube();
    view::SpaceView* space = stage()->space();
    QTRY_COMPARE(space->mapItem().count(), std::size_t(5));
    panel()->table()->selectRow(2);
    const std::vector<ifs::MapId> ids{panel()->model()->idAt(1), panel()->model()->idAt(2)};
    panel()->selectMaps(ids);
    QCOMPARE(rows(), (Rows{1, 2}));
    const std::size_t free = held(), other = free == 1 ? 2 : 1;
    const auto map = [this](std::size_t k) { return document::system3(document().fractal())->maps[k].map; };
    const auto drag = [&](std::size_t handle, Qt::KeyboardModifiers modifiers) {
        const auto cage = *document::knownSpaceCage(document().fractal());
        const auto handles = document::SpaceMapHandles(document().sharedFractal(), cage);
        const ifs::Vector<3> vertex = view::handlesOf(handles.corners(free))[handle];
        const QPoint from =
            view::toPoint(attractor::toScreen(space->navigation().camera(), vertex).pixel).toPoint();
        QTest::mousePress(space->viewport(), Qt::LeftButton, modifiers, from);
        for (const int x : {10, 20})
            QTest::mouseMove(space->viewport(), from - QPoint(x, x / 2));
        QTest::mouseRelease(space->viewport(), Qt::LeftButton, modifiers, from - QPoint(20, 10));
    };
    const auto before = document().sharedFractal();
    const auto was = [&](std::size_t k) { return document::system3(*before)->maps[k].map; };

    drag(view::SpaceMaps::middle, Qt::NoModifier);
    QCOMPARE(document().undoStack()->undoText(), QStringLiteral("Move 2 maps"));
    const ifs::Vector<3> by = map(free).translation - was(free).translation;
    QVERIFY(by.norm() > 1e-3);
    QVERIFY((map(other).translation - was(other).translation - by).norm() < 1e-9);
    QVERIFY(map(0) == was(0));
    document().undoStack()->undo();
    QVERIFY(map(free) == was(free) && map(other) == was(other));

    drag(0, Qt::AltModifier);
    QCOMPARE(document().undoStack()->undoText(), QStringLiteral("Scale 2 maps"));
    const ifs::Matrix<3> grown = map(free).linear * was(free).linear.inverse();
    QVERIFY(!grown.isIdentity(1e-3));
    QVERIFY((map(other).linear * was(other).linear.inverse()).isApprox(grown, 1e-9));
    document().undoStack()->undo();

    drag(0, Qt::NoModifier);
    QVERIFY(map(free) != was(free) && map(other) == was(other));
    document().undoStack()->undo();

    document::lockMaps(document(), std::array{document::system3(*before)->maps[other].id}, true);
    drag(view::SpaceMaps::middle, Qt::NoModifier);
    QCOMPARE(document().undoStack()->undoText(), QStringLiteral("Move map %1").arg(free + 1));
    QVERIFY(map(free) != was(free) && map(other) == was(other));
}

void MapsConnectionsTest::fourViewsHoldTheSame() {
    showCube();
    panel()->table()->selectRow(5);
    stage()->plane()->setTool(view::CanvasView::Tool::Cage);
    stage()->views()->showFour(true);
    stage()->plane()->setTool(view::CanvasView::Tool::Maps);
    for (const view::SpaceView* other : stage()->views()->others())
        QVERIFY(other->heldMap() == std::size_t(5));
    press(stage()->views()->others().front(), Qt::Key_2, Qt::AltModifier);
    QCOMPARE(held(), std::size_t(1));
    QCOMPARE(rows(), Rows{1});
}

void MapsConnectionsTest::nothingIsOfferedSideBySide() {
    showCube();
    const auto* bar = m_window->findChild<view::ToolOptionsBar*>();
    const QString usual = bar->hint();
    stage()->views()->setStereo(attractor::Stereo::SideBySide);
    QVERIFY2(bar->hint().contains(QStringLiteral("switch stereo off")), qPrintable(bar->hint()));
    stage()->views()->setStereo(attractor::Stereo::None);
    QCOMPARE(bar->hint(), usual);
}

void MapsConnectionsTest::copyAndPasteAreOfMaps() {
    showCube();
    press(stage()->space(), Qt::Key_3, Qt::AltModifier);
    choose("copy");
    QVERIFY(view::holdsOurMaps(*QGuiApplication::clipboard()->mimeData()));
    choose("paste");
    QCOMPARE(document().file().entries.size(), 1);
    QCOMPARE(panel()->model()->rowCount(), 9);
    const auto& maps = document::system3(document().fractal())->maps;
    QVERIFY(maps.at(8).map == maps.at(2).map);
    QCOMPARE(held(), std::size_t(8)); // what was pasted is selected
}

BARYCAGE_TEST(MapsConnectionsTest, QApplication);
#include "maps_connections_test.moc"
