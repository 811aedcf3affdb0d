// SPDX-License-Identifier: MIT
#include "ifs/existence/attractor_existence.h"
#include "panels/maps/maps_panel.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"

#include <QPixmap>
#include <QSignalSpy>

#include <cmath>

// The maps taken on the canvas by the images of the cage.
class MapsToolTest : public CanvasFixture {
    Q_OBJECT

    const ifs::AffineMap<2>& map(std::size_t place) const { return system().maps[place].map; }
    QPointF corner(int map, int index) const { return at({Kind::Vertex, index, map}); }
    QPointF middle(int map) const { return at({Kind::Inside, 0, map}); }
    Vector<2> inPlane(const QPointF& pixels) const { return view::worldOffset(m_canvas->camera(), pixels); }
    ifs::Verdict verdict() const { return ifs::classify<2>(ifs::activeMaps(system()).maps).verdict; }
    Qt::CursorShape cursorAt(const QPointF& p) {
        hover(p);
        return cursor();
    }

private slots:
    void init() {
        open();
        m_canvas->setTool(CanvasView::Tool::Maps);
    }
    void cleanup() { close(); }

    void handsOverTheCorners() {
        QCOMPARE(cursorAt(corner(1, 2)), Qt::OpenHandCursor);
        QCOMPARE(cursorAt(middle(1)), Qt::CrossCursor);
        press(corner(1, 2));
        move(corner(1, 2) + QPointF(9, 9));
        QCOMPARE(m_canvas->viewport()->cursor().shape(), Qt::ClosedHandCursor);
    }

    // From the empty canvas, over the whole of each frame in turn.
    void aRectangleSelectsTheMapsItEncloses() {
        const QPointF start(3, 3);
        QCOMPARE(scene().partAt(start, view::Reach::Mouse).kind, Kind::None);
        bool some = false;
        for (int each = 0; each < 3; ++each) {
            QPointF end;
            for (int i = 0; i < 3; ++i)
                end = {std::max(end.x(), corner(each, i).x() + 2),
                       std::max(end.y(), corner(each, i).y() + 2)};
            std::vector<ifs::MapId> enclosed;
            for (int other = 0; other < 3; ++other) {
                bool all = true;
                for (int i = 0; i < 3; ++i)
                    all = all && QRectF(start, end).contains(corner(other, i));
                if (all) enclosed.push_back(system().maps[std::size_t(other)].id);
            }
            drag(start, end - start);
            QCOMPARE(m_canvas->selectedMaps(), enclosed);
            some = some || enclosed.size() < 3;
        }
        QVERIFY(some);
        QCOMPARE(steps(), 0);
    }

    void aRectangleIsSeenAddsAndIsTakenBack() {
        const QPointF start(3, 3);
        const ifs::MapId first = system().maps[0].id;
        click(middle(0));
        QTRY_VERIFY_WITH_TIMEOUT(m_bridge->isCurrent(), 60'000);
        const QImage before = m_canvas->grab().toImage();
        press(start, Qt::ShiftModifier);
        move({60, 50}, Qt::ShiftModifier);
        QCOMPARE(m_canvas->selectedMaps(), (std::vector<ifs::MapId>{first}));
        QCOMPARE(cursor(), Qt::CrossCursor);
        const QImage with = m_canvas->grab().toImage();
        for (const QPoint& onIt : {QPoint(60, 20), QPoint(30, 50), QPoint(30, 20)})
            QVERIFY(with.pixel(onIt) != before.pixel(onIt));
        move({639, 479}, Qt::ShiftModifier);
        QCOMPARE(m_canvas->selectedMaps().size(), std::size_t{3});
        key(Qt::Key_Escape);
        QCOMPARE(m_canvas->selectedMaps(), (std::vector<ifs::MapId>{first}));
        release({639, 479});
        click(start); // alone it selects nothing
        QVERIFY(m_canvas->selectedMaps().empty());
        QCOMPARE(steps(), 0);
    }

    // The first map of the triangle has a corner in common with the cage.
    void theHintDoesNotHideTheVertex() {
        m_canvas->setTool(CanvasView::Tool::Cage);
        QTRY_VERIFY_WITH_TIMEOUT(m_bridge->isCurrent(), 60'000);
        const auto grabbed = [this] { return m_canvas->viewport()->grab().toImage(); };
        m_canvas->selectMaps({});
        const QImage without = grabbed();
        m_canvas->selectMaps({system().maps[0].id});
        QCOMPARE(grabbed(), without); // nothing in the way of the picture
        m_canvas->pointAt(system().maps[0].id);
        const QImage with = grabbed();
        m_canvas->pointAt(ifs::MapId::None);
        QCOMPARE(grabbed(), without);
        QVERIFY(with != without); // there is a hint
        const QPoint vertex = at({Kind::Vertex, 0}).toPoint();
        const QRect handle(vertex - QPoint(4, 4), QSize(9, 9));
        QCOMPARE(with.copy(handle), without.copy(handle));
    }

    void keysDeleteAndDuplicate() {
        QSignalSpy said(m_canvas.get(), &CanvasView::message);
        key(Qt::Key_Delete); // nothing is selected
        QCOMPARE(steps(), 0);
        QCOMPARE(said.last().first().toString(), QStringLiteral("Select a map first."));
        const document::System2 code = system();
        click(middle(1));
        key(Qt::Key_Insert);
        QCOMPARE(undoText(), QStringLiteral("Duplicate a map"));
        QCOMPARE(system().maps.size(), std::size_t{4});
        QVERIFY(map(2) == code.maps[1].map);
        QCOMPARE(m_canvas->selectedMaps(), (std::vector<ifs::MapId>{system().maps[2].id}));
        key(Qt::Key_Delete); // the copy
        QCOMPARE(steps(), 2);
        QVERIFY(system().maps == code.maps);
        press(middle(1));
        move(middle(1) + QPointF(9, 9));
        key(Qt::Key_Delete); // not while something is held
        QCOMPARE(system().maps.size(), std::size_t{3});
        release(middle(1));
    }

    // A change of rank one in one step; the other maps and the cage stay.
    void aCornerFollowsThePointer() {
        const document::Fractal before = m_document->fractal();
        const document::System2 code = system();
        const ifs::ControlCage<2> cage = *scene().handles().cage();
        const QPointF offset(23, -17);
        drag(corner(2, 1) + QPointF(2, 1), offset);
        QCOMPARE(steps(), 1);
        QVERIFY(undoText().startsWith(QStringLiteral("Move corner 2 of map 3 ")));
        QVERIFY((map(2)(cage.rest[1]) - code.maps[2].map(cage.rest[1]) - inPlane(offset)).norm() < 1e-12);
        for (const std::size_t other : {0U, 2U})
            QVERIFY((map(2)(cage.rest[other]) - code.maps[2].map(cage.rest[other])).norm() < 1e-12);
        QVERIFY(map(0) == code.maps[0].map && map(1) == code.maps[1].map);
        QVERIFY(*scene().handles().cage() == cage);
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == before);
    }

    // The picture in the middle of a drag is as full as any: it is the same renderer's.
    void theAttractorFollows() {
        QTRY_VERIFY_WITH_TIMEOUT(m_bridge->isCurrent(), 60'000);
        const auto before = m_bridge->frame()->pixels;
        press(middle(2));
        move(middle(2) + QPointF(30, 20));
        QTRY_VERIFY_WITH_TIMEOUT(m_bridge->isCurrent() && m_bridge->frame()->samples >= 1'000'000, 60'000);
        QVERIFY(m_bridge->frame()->pixels != before);
        release(middle(2));
    }

    void theInsideMovesAllThatAreSelected() {
        const document::System2 code = system();
        click(middle(0));
        click(middle(1), Qt::ShiftModifier);
        QCOMPARE(m_canvas->selectedMaps(), (std::vector<ifs::MapId>{code.maps[0].id, code.maps[1].id}));
        drag(middle(1), {11, 7});
        QVERIFY(undoText().startsWith(QStringLiteral("Move 2 maps ")));
        QCOMPARE(steps(), 1);
        for (const std::size_t i : {0U, 1U}) {
            QVERIFY(map(i).linear == code.maps[i].map.linear);
            QVERIFY((map(i).translation - code.maps[i].map.translation - inPlane({11, 7})).norm() < 1e-12);
        }
        QVERIFY(map(2) == code.maps[2].map);
        click(middle(1), Qt::ControlModifier); // taken out again
        QCOMPARE(m_canvas->selectedMaps(), (std::vector<ifs::MapId>{code.maps[0].id}));
    }

    void handlesTurnAndScaleAboutTheMiddle() {
        click(middle(1));
        const document::System2 code = system();
        const Vector<2> about = scene().handles().pivot();
        drag(at({Kind::Rotate, 0}), {-10, 40});
        QVERIFY(undoText().startsWith(QStringLiteral("Rotate map 2 ")));
        const auto& rest = scene().handles().cage()->rest;
        for (const Vector<2>& vertex : rest)
            QVERIFY(std::abs((map(1)(vertex) - about).norm() - (code.maps[1].map(vertex) - about).norm()) <
                    1e-12);
        QVERIFY((map(1).linear - code.maps[1].map.linear).norm() > 0.05);
        drag(at({Kind::Scale, 0}), {-20, -20});
        QVERIFY(undoText().startsWith(QStringLiteral("Scale map 2 ")));
        QVERIFY(ifs::spectralNorm<2>(map(1).linear) < 0.49);
        QCOMPARE(steps(), 2);
        drag(middle(1) + QPointF(20, 8), {0, 30}, Qt::ControlModifier); // as the cage
        QVERIFY(undoText().startsWith(QStringLiteral("Rotate map 2 ")));
    }

    // Where the attractor ends the drag ends, and says which map does it and by how much.
    void aDragStopsWhereTheAttractorWouldBeLost() {
        const QPointF start = corner(1, 1);
        press(start);
        move(start + QPointF(40, 0));
        QVERIFY(stopNote().isEmpty());
        move(start + QPointF(2000, 0));
        QVERIFY(ifs::classify<2>(ifs::activeMaps(system()).maps).verdict == ifs::Verdict::Hyperbolic ||
                verdict() == ifs::Verdict::EventuallyContractive);
        QVERIFY(ifs::spectralNorm<2>(map(1).linear) > 0.99); // whichever way the corner turns it
        QVERIFY(stopNote().contains(QStringLiteral("map 2")));
        QVERIFY(stopNote().contains(QStringLiteral("largest singular value 1")));
        move(start + QPointF(40, 0)); // and back
        QVERIFY(stopNote().isEmpty());
        release(start + QPointF(40, 0));
        QCOMPARE(steps(), 1);
    }

    void orGoesThroughWhenAllowed() {
        m_canvas->tools().setAllowsNoAttractor(true);
        drag(corner(1, 1), {2000, 0});
        QVERIFY(verdict() == ifs::Verdict::None);
        QVERIFY(stopNote().isEmpty());
        QVERIFY(m_canvas->note().contains(QStringLiteral("No attractor: map 2")));
        QTRY_VERIFY_WITH_TIMEOUT(m_bridge->isCurrent(), 60'000);
        QVERIFY(m_canvas->note().contains(QStringLiteral("No attractor: map 2")));
        m_document->undoStack()->undo(); // what is proved waits for no picture
        QVERIFY2(!m_canvas->note().contains(QStringLiteral("attractor")), qPrintable(m_canvas->note()));
        m_document->undoStack()->redo();
        QVERIFY(m_canvas->note().contains(QStringLiteral("No attractor: map 2")));
        // From there on nothing stops the way back.
        m_canvas->tools().setAllowsNoAttractor(false);
        m_canvas->fit();
        drag(corner(1, 1), corner(1, 0) - corner(1, 1) + QPointF(20, 0));
        QCOMPARE(steps(), 2);
        QCOMPARE(verdict(), ifs::Verdict::Hyperbolic);
    }

    void aNudgeStopsToo() {
        QTest::keyClick(m_canvas.get(), Qt::Key_2, Qt::AltModifier);
        QCOMPARE(scene().selection().focused(), (CanvasPart{Kind::Inside, 0, 1}));
        QTest::keyClick(m_canvas.get(), Qt::Key_Tab);
        QTest::keyClick(m_canvas.get(), Qt::Key_Tab);
        QCOMPARE(scene().selection().focused(), (CanvasPart{Kind::Vertex, 1, 1}));
        for (int i = 0; i < 60; ++i)
            QTest::keyClick(m_canvas.get(), Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(verdict(), ifs::Verdict::Hyperbolic);
        QVERIFY(ifs::spectralNorm<2>(map(1).linear) > 0.99); // whichever way the corner turns it
        QTest::keyClick(m_canvas.get(), Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(ifs::spectralNorm<2>(map(1).linear) < 0.99);
    }

    void escapeRestoresExactly() {
        const document::Fractal before = m_document->fractal();
        press(corner(0, 1));
        move(corner(0, 1) + QPointF(12, 30));
        QVERIFY(m_document->fractal() != before);
        QTest::keyClick(m_canvas.get(), Qt::Key_Escape);
        QVERIFY(m_document->fractal() == before);
        release(QPointF(300, 300));
        QCOMPARE(steps(), 0);
        press(corner(0, 1)); // nor does the way back leave a step
        const QPointF start = corner(0, 1);
        move(start + QPointF(40, 40));
        move(start);
        release(start);
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(steps(), 0);
    }

    void arrowsNudgeAndTheSelectionFollowsTheFocus() {
        for (int i = 0; i < 5; ++i) // map 1, its three corners, map 2
            QTest::keyClick(m_canvas.get(), Qt::Key_Tab);
        QCOMPARE(scene().selection().focused(), (CanvasPart{Kind::Inside, 0, 1}));
        QCOMPARE(m_canvas->selectedMaps(), (std::vector<ifs::MapId>{system().maps[1].id}));
        const Vector<2> before = map(1).translation;
        QTest::keyClick(m_canvas.get(), Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY((map(1).translation - before - inPlane({0, -10})).norm() < 1e-12);
        QCOMPARE(steps(), 1);
        QTest::keyClick(m_canvas.get(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(m_canvas->selectedMaps().size(), std::size_t(3));
    }

    void theTableAndTheCanvasSelectTogether() {
        view::MapsPanel panel(m_document.get());
        connect(&panel, &view::MapsPanel::selectionChanged, m_canvas.get(),
                [&] { m_canvas->selectMaps(panel.selectedMaps()); });
        const std::vector<ifs::MapId> last{system().maps[2].id};
        panel.selectMaps(last);
        QCOMPARE(m_canvas->selectedMaps(), last);
        QCOMPARE(scene().selection().mapIndices(), std::vector<std::size_t>{2});
        panel.deleteMaps();
        QVERIFY(m_canvas->selectedMaps() != last);
        QCOMPARE(scene().selection().mapCount(), 2);
    }

    // Frames of all would keep the window too long.
    void ofVeryManyThoseInViewAreTaken() {
        document::Fractal many;
        document::System2 system;
        constexpr int side = 150;
        for (int i = 0; i < side * side; ++i)
            system.maps.push_back({.id = ifs::MapId{std::uint32_t(i + 1)},
                                   .map = ifs::affineMap(0.8 / side, 0, 0, 0.8 / side,
                                                         double(i % side) / side, double(i / side) / side),
                                   .weight = {}});
        many.shape = document::Shape<2>{system};
        m_document->edit(QStringLiteral("many"), many);
        QSignalSpy said(m_canvas.get(), &CanvasView::message);
        m_canvas->setTool(CanvasView::Tool::Cage);
        m_canvas->fit();
        m_canvas->setTool(CanvasView::Tool::Maps);
        QCOMPARE(said.size(), 1);
        QVERIFY(scene().frames().size() > 5000 && scene().frames().size() <= 10'000);
        int hidden = side * side - 1;
        while (view::frameOf(scene().frames(), hidden))
            --hidden;

        // A rectangle takes them all the same.
        drag({1, 1}, {600, 470});
        QVERIFY(m_canvas->selectedMaps().size() == std::size_t(side * side));
        key(Qt::Key_Escape);

        // What is walked to has a frame.
        m_canvas->findChild<view::CanvasScene*>()->selection().setFocused({Kind::Inside, 0, hidden});
        QVERIFY(view::frameOf(scene().frames(), hidden));
        m_canvas->findChild<view::CanvasScene*>()->selection().setFocused({});

        hidden -= side / 2;
        while (QLineF(corner(hidden, 0), corner(hidden, 1)).length() < 60) {
            m_canvas->navigation().zoomBy(1.5);
            const QPointF from = middle(hidden), to(320, 240);
            press(from, {}, Qt::MiddleButton);
            move(to, {}, Qt::MiddleButton);
            release(to, {}, Qt::MiddleButton);
        }
        QVERIFY(view::frameOf(scene().frames(), hidden));
        const QPointF start = corner(hidden, 1);
        const auto before = map(std::size_t(hidden));
        drag(start, {12, 7});
        QVERIFY(!(map(std::size_t(hidden)) == before));
        QVERIFY(QLineF(corner(hidden, 1), start + QPointF(12, 7)).length() < 1e-6);
    }

    // However near one looks at a corner of it.
    void ofVeryManyALargeOneIsTakenByItsCorner_data() {
        QTest::addColumn<bool>("bends");
        QTest::newRow("affine") << false;
        QTest::newRow("bent") << true;
    }
    void ofVeryManyALargeOneIsTakenByItsCorner() {
        QFETCH(bool, bends);
        document::Fractal many;
        document::System2 system;
        for (int i = 0; i < 10'000; ++i)
            system.maps.push_back(
                {.id = ifs::MapId{std::uint32_t(i + 1)},
                 .map = ifs::affineMap(0.001, 0, 0, 0.001, i % 100 / 100.0, i / 100 / 100.0),
                 .weight = {}});
        many.shape = document::Shape<2>{system};
        const std::vector<Vector<2>> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        document::plane(many)->cage = ifs::ControlCage<2>{square, square};
        if (bends) document::plane(many)->cage->current[2] = {1.3, 1.2};
        m_document->edit(QStringLiteral("many"), many);
        m_canvas->fit();
        m_canvas->setTool(CanvasView::Tool::Cage);
        QSignalSpy said(m_canvas.get(), &CanvasView::message);
        m_canvas->setTool(CanvasView::Tool::Maps);
        QCOMPARE(scene().frames().size(), std::size_t{10'000}); // just not too many
        QVERIFY(said.isEmpty());

        document::Fractal more = m_document->fractal();
        document::system2(more)->maps.push_back(
            {.id = ifs::MapId{20'000}, .map = ifs::affineMap(0.5, 0, 0, 0.5, 0.1, 0.1), .weight = {}});
        m_document->edit(QStringLiteral("one more"), more);
        constexpr int last = 10'000;
        const auto nearer = [&](double width) {
            while (QLineF(corner(last, 0), corner(last, 1)).length() < width) {
                const QPointF from = corner(last, 2), to(320, 240);
                press(from, {}, Qt::MiddleButton);
                move(to, {}, Qt::MiddleButton);
                release(to, {}, Qt::MiddleButton);
                m_canvas->navigation().zoomBy(1.5);
            }
        };
        nearer(800);
        QVERIFY(view::frameOf(scene().frames(), last));
        drag(corner(last, 2), {12, 7});
        QCOMPARE(m_canvas->selectedMaps(), std::vector<ifs::MapId>{ifs::MapId{20'000}});
        nearer(bends ? 1200 : 20'000); // the box of a bent one is not exact, but it is selected
        QVERIFY(view::frameOf(scene().frames(), last));
        const QPointF start = corner(last, 2);
        drag(start, {12, 7});
        QVERIFY(QLineF(corner(last, 2), start + QPointF(12, 7)).length() < (bends ? 1 : 1e-3));
        QVERIFY(scene().frames().size() < 10'000);
    }

    // The cage drags the same maps: they are its children on the screen.
    void underADraggedCageTheyAreWhereTheyAreSeen() {
        m_canvas->setTool(CanvasView::Tool::Cage);
        drag(at({Kind::Vertex, 2}), {-60, 50});
        m_canvas->setTool(CanvasView::Tool::Maps);
        click(middle(1)); // of two corners in one place, that of the map selected
        const QPointF start = corner(1, 2);
        const QPointF target = start + QPointF(14, 9);
        drag(start, {14, 9});
        QVERIFY(QLineF(corner(1, 2), target).length() < 1e-6);
        QCOMPARE(steps(), 2);
    }

    void aFlatCageSaysWhyNothingMoves() {
        m_canvas->setTool(CanvasView::Tool::Cage);
        drag(at({Kind::Vertex, 2}), at({Kind::Edge, 0}) - at({Kind::Vertex, 2}));
        m_canvas->setTool(CanvasView::Tool::Maps);
        QSignalSpy said(m_canvas.get(), &CanvasView::message);
        drag(middle(0), {20, 20});
        QCOMPARE(steps(), 1);
        QVERIFY(!said.isEmpty());
        QVERIFY(said.back().front().toString().contains(QStringLiteral("flat")));
    }
};

BARYCAGE_TEST(MapsToolTest, QApplication);
#include "maps_tool_test.moc"
