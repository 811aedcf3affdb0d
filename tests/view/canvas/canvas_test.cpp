// SPDX-License-Identifier: MIT
#include "attractor/render/renderer.h"
#include "canvas/items/symmetry_item.h"
#include "canvas/tools/vertex_dialog.h"
#include "document/edits/cage/cage_actions.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "support/events.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"
#include "widgets/numbers/number_text.h"

#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>

class CanvasTest : public CanvasFixture {
    Q_OBJECT

private slots:
    void init() { open(); }

    void cleanup() { close(); }

    void handOverAVertexAndCrossElsewhere() {
        hover(vertex(1));
        QCOMPARE(cursor(), Qt::OpenHandCursor);
        hover(empty());
        QCOMPARE(cursor(), Qt::CrossCursor);
        hover(inside());
        QCOMPARE(cursor(), Qt::CrossCursor);
        press(vertex(1));
        QCOMPARE(cursor(), Qt::ClosedHandCursor);
        move(vertex(1) + QPoint(40, 10));
        QCOMPARE(cursor(), Qt::ClosedHandCursor);
        release(vertex(1));
        QCOMPARE(cursor(), Qt::OpenHandCursor);
    }

    void aVertexFollowsThePointerInOneStep() {
        const std::vector<Vector<2>> before = vertices();
        const attractor::Camera camera = m_canvas->camera();
        drag(vertex(2) + QPoint(3, -2), {57, -31}); // not taken at its middle: it must not jump
        const Vector<2> expected = before[2] + view::worldOffset(camera, {57, -31});
        QCOMPARE(vertices()[2], expected);
        QCOMPARE(vertices()[0], before[0]);
        QCOMPARE(vertices()[1], before[1]);
        QCOMPARE(steps(), 1);
        QCOMPARE(m_document->undoStack()->undoText(),
                 QStringLiteral("Move vertex 3 to (%1, %2)")
                     .arg(view::shortNumber(expected.x()), view::shortNumber(expected.y())));
        QVERIFY(m_canvas->camera() == camera);
        m_document->undoStack()->undo();
        QVERIFY(vertices() == before);
    }

    // A sentence makes way for the handles, wherever they are brought.
    void sentencesCoverNoHandle() {
        m_canvas->setHint(
            QStringLiteral("Drag a corner of the triangle. Or press D and click three points."));
        const view::NoteItem* note = nullptr;
        for (const QGraphicsItem* item : scene().items())
            if (const auto* found = dynamic_cast<const view::NoteItem*>(item);
                found && !found->text().isEmpty())
                note = found;
        QVERIFY(note);
        for (const QPointF& place :
             {note->box().center(), QPointF(320, 30), QPointF(60, 450), QPointF(600, 450)}) {
            const QPoint from = vertex(1);
            m_document->edit(QStringLiteral("move"), [&] {
                document::Fractal fractal = m_document->fractal();
                ifs::ControlCage<2> cage = document::effectiveCage(fractal);
                cage.current[1] += view::worldOffset(m_canvas->camera(), place - QPointF(from));
                document::plane(fractal)->cage = cage;
                return fractal;
            }());
            for (int i = 0; i < 3; ++i)
                QVERIFY(!note->box().adjusted(-8, -8, 8, 8).contains(vertex(i)));
            for (const Kind knob : {Kind::Rotate, Kind::Scale, Kind::Pivot})
                QVERIFY(!note->box().adjusted(-8, -8, 8, 8).contains(at({knob, 0})));
        }
    }

    // Of however many lines it is.
    void aSentenceKeepsOffACard() {
        m_canvas->resize(330, 460);
        const QRect card(14, 280, 300, 120);
        const QString text =
            QStringLiteral("Drag a corner of the triangle. Or press D and click the three points "
                           "that are to become the corners of another triangle. The picture stays "
                           "where it is, and so does the code of its maps until you bake the cage.");
        m_canvas->setCovered(card);
        m_canvas->setHint(text);
        QTRY_COMPARE(m_canvas->viewport()->size(), QSize(330, 460));
        const view::NoteItem* note = nullptr;
        for (const QGraphicsItem* item : scene().items())
            if (const auto* found = dynamic_cast<const view::NoteItem*>(item); found && found->text() == text)
                note = found;
        QVERIFY(note);
        QVERIFY(note->box().height() > 60); // so that it reaches behind the card from the edge
        QVERIFY(!note->box().intersects(card));
        QVERIFY(QRectF(m_canvas->viewport()->rect()).contains(note->box()));
    }

    void sentencesCoverNoOtherHandle_data() {
        QTest::addColumn<int>("tool");
        QTest::newRow("cage") << int(CanvasView::Tool::Cage);
        QTest::newRow("maps") << int(CanvasView::Tool::Maps);
        QTest::newRow("branch") << int(CanvasView::Tool::Branch);
    }

    // Each handle in turn is brought under the sentence, with all that is on the canvas.
    void sentencesCoverNoOtherHandle() {
        QFETCH(int, tool);
        const ifs::Symmetry<2> symmetry{ifs::SymmetryGroup::Rotation, 3, 0, {0.5, 0.3}};
        m_canvas->setTool(CanvasView::Tool(tool));
        std::vector<CanvasPart> parts{{Kind::Rotate, 0}, {Kind::Scale, 0}, {Kind::Pivot, 0}};
        if (m_canvas->tool() == CanvasView::Tool::Maps) m_canvas->selectMaps({system().maps[1].id});
        if (m_canvas->tool() == CanvasView::Tool::Branch) {
            click(m_canvas->canvas().cagePolygon().first()); // a point of the attractor
            QVERIFY(!scene().handles().branch().empty());
        }
        const bool isCage = m_canvas->tool() == CanvasView::Tool::Cage;
        if (isCage)
            m_document->edit(QStringLiteral("symmetric"),
                             document::withSymmetry(m_document->fractal(), symmetry));
        QCOMPARE(scene().knobs().symmetry.knob().has_value(), isCage);
        for (int map = isCage ? -1 : 0; map < (isCage ? 0 : scene().handles().childCount()); ++map)
            for (int i = 0; i < 3; ++i)
                parts.push_back({Kind::Vertex, i, map});
        const QString text = QStringLiteral("Drag a corner.");
        m_canvas->setHint(text);
        const view::NoteItem* note = nullptr;
        for (const QGraphicsItem* item : scene().items())
            if (const auto* found = dynamic_cast<const view::NoteItem*>(item); found && found->text() == text)
                note = found;
        QVERIFY(note);
        const auto handles = [&] {
            std::vector<QPointF> positions;
            for (const CanvasPart& part : parts)
                positions.push_back(at(part));
            if (const auto knob = scene().knobs().symmetry.knob()) positions.push_back(*knob);
            return positions;
        };
        for (std::size_t k = 0; k < handles().size(); ++k) {
            const QPointF by = note->box().center() - handles()[k];
            document::Fractal fractal = m_document->fractal();
            ifs::ControlCage<2> cage = document::effectiveCage(fractal);
            for (auto& corner : cage.current)
                corner += view::worldOffset(m_canvas->camera(), by);
            document::plane(fractal)->cage = cage;
            m_document->edit(QStringLiteral("move"), fractal);
            for (const QPointF& position : handles())
                QVERIFY(!note->box().adjusted(-8, -8, 8, 8).contains(position));
        }
    }

    // Cage and picture move together.
    void aMoveIsPaintedWithItsPicture() {
        QTRY_VERIFY(m_bridge->isCurrent());
        press(vertex(1));
        move(vertex(1) + QPoint(20, 10));
        QVERIFY(!m_bridge->isCurrent());
        QCOMPARE(m_canvas->viewportUpdateMode(), QGraphicsView::NoViewportUpdate);
        QTRY_VERIFY(m_bridge->isCurrent());
        QCOMPARE(m_canvas->viewportUpdateMode(), QGraphicsView::FullViewportUpdate);
    }

    void aMomentIsPaintedWithItsPicture() {
        document::Fractal breathing = m_document->fractal();
        auto& animation = document::plane(breathing)->animation.emplace();
        animation.length = 48;
        animation.motions = {animation::Breathe<2>{{}, 0.5, 1, {0, 0}}};
        m_document->edit(QStringLiteral("breathe"), breathing);
        QTRY_VERIFY(m_bridge->isCurrent());
        m_document->setMoment(animation::moment(12));
        QVERIFY(!m_bridge->isCurrent());
        QCOMPARE(m_canvas->viewportUpdateMode(), QGraphicsView::NoViewportUpdate);
        QTRY_VERIFY(m_bridge->isCurrent());
        QCOMPARE(m_canvas->viewportUpdateMode(), QGraphicsView::FullViewportUpdate);
    }

    // Finding the address under the pointer takes time that the picture of every moment needs.
    void thePointIsReadAgainAtRest() {
        hover(vertex(1));
        m_canvas->viewport()->setAttribute(Qt::WA_UnderMouse);
        QSignalSpy spy(m_canvas.get(), &CanvasView::pointerMoved);
        document::Fractal fractal = m_document->fractal();
        for (int change = 0; change < 3; ++change) {
            document::system2(fractal)->maps[0].map.linear *= 0.9;
            m_document->edit(QStringLiteral("shrink"), fractal);
            QCoreApplication::sendPostedEvents();
        }
        QCOMPARE(spy.count(), 0);
        QTRY_COMPARE(spy.count(), 1);
    }

    void aMoveIsPaintedThoughItsPictureIsLate() {
        QTRY_VERIFY(m_bridge->isCurrent());
        m_bridge->fixLiveSamples(std::uint64_t{1} << 40);
        press(vertex(1));
        move(vertex(1) + QPoint(20, 10));
        QCOMPARE(m_canvas->viewportUpdateMode(), QGraphicsView::NoViewportUpdate);
        QTRY_COMPARE(m_canvas->viewportUpdateMode(), QGraphicsView::FullViewportUpdate);
        QVERIFY(!m_bridge->isCurrent());
    }

    void edgeAndInsideMoveTheirVertices() {
        const std::vector<Vector<2>> before = vertices();
        const Vector<2> offset = view::worldOffset(m_canvas->camera(), {20, 15});
        const QPointF third = m_canvas->canvas().positionOf({Kind::Vertex, 0}) * 0.7 +
                              m_canvas->canvas().positionOf({Kind::Vertex, 1}) * 0.3;
        drag(third, {20, 15});
        QVERIFY((vertices()[0] - before[0] - offset).norm() < 1e-12);
        QVERIFY((vertices()[1] - before[1] - offset).norm() < 1e-12);
        QCOMPARE(vertices()[2], before[2]);
        m_document->undoStack()->undo();
        drag(inside(), {20, 15});
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY((vertices()[i] - before[i] - offset).norm() < 1e-12);
        QCOMPARE(steps(), 1);
    }

    void escapeRestoresExactly() {
        drag(vertex(0), {31, 17});
        const document::Fractal before = m_document->fractal();
        for (const Qt::KeyboardModifiers modifiers :
             {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ControlModifier),
              Qt::KeyboardModifiers(Qt::AltModifier)}) {
            press(vertex(1), modifiers);
            move(vertex(1) + QPoint(33, 44), modifiers);
            QVERIFY(m_document->fractal() != before);
            QTest::keyClick(m_canvas.get(), Qt::Key_Escape);
            QVERIFY(m_document->fractal() == before);
            move(QPointF(300, 300), modifiers); // the button is still down: nothing may follow it
            release(QPointF(300, 300), modifiers);
            QVERIFY(m_document->fractal() == before);
        }
        QCOMPARE(steps(), 1);
    }

    void wayBackLeavesNoStep() {
        const document::Fractal before = m_document->fractal();
        const QPoint start = vertex(0);
        press(start);
        move(start + QPoint(50, 50));
        move(start);
        release(start);
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(steps(), 0);
        click(vertex(1)); // nor does a click
        QCOMPARE(steps(), 0);
        QCOMPARE(m_canvas->canvas().selection().focused(), (CanvasPart{Kind::Vertex, 1}));
    }

    void flatAndBackIsTheSamePicture() {
        const auto isAtRest = [this] {
            return m_bridge->isCurrent() && m_bridge->frame()->samples >= 1'000'000 &&
                   m_bridge->frame()->shown == m_bridge->frame()->exposure;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 60'000);
        const document::Fractal before = m_document->fractal();
        const auto wanted = m_bridge->frame()->pixels;
        const QPointF start = m_canvas->canvas().positionOf({Kind::Vertex, 2});
        const QPointF edge = m_canvas->canvas().positionOf({Kind::Edge, 0});
        press(start);
        move(edge);
        QVERIFY(!document::isPlacementInvertible(m_document->fractal()));
        move(edge + (edge - start)); // mirrored
        move(start);
        release(start);
        QVERIFY(m_document->fractal() == before);
        QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 60'000);
        QVERIFY(m_bridge->frame()->pixels == wanted);
    }

    void controlTurnsAndAltScalesAboutThePivot() {
        const Vector<2> pivot = m_canvas->canvas().handles().pivot();
        const std::vector<Vector<2>> before = vertices();
        drag(vertex(1), {-60, -80}, Qt::ControlModifier);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(std::abs((vertices()[i] - pivot).norm() - (before[i] - pivot).norm()) < 1e-9);
        QVERIFY((vertices()[1] - before[1]).norm() > 0.01);
        m_document->undoStack()->undo();
        const QPointF outwards = (vertex(1) - m_canvas->canvas().positionOf({Kind::Pivot, 0})) * 0.25;
        drag(vertex(1), outwards, Qt::AltModifier);
        const double ratio = (vertices()[0] - pivot).norm() / (before[0] - pivot).norm();
        QVERIFY(ratio > 1.01);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY((vertices()[i] - pivot - ratio * (before[i] - pivot)).norm() < 1e-9);
        QCOMPARE(steps(), 1);
    }

    void shiftScalesAlongOneAxis() {
        const Vector<2> pivot = m_canvas->canvas().handles().pivot();
        const std::vector<Vector<2>> before = vertices();
        drag(vertex(2), {10, -60}, Qt::AltModifier | Qt::ShiftModifier);
        const double ratio = (vertices()[2].y() - pivot.y()) / (before[2].y() - pivot.y());
        QVERIFY(ratio > 1.1);
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(vertices()[i].x(), before[i].x());
            QVERIFY(std::abs(vertices()[i].y() - pivot.y() - ratio * (before[i].y() - pivot.y())) < 1e-9);
        }
    }

    // As it must be where the window manager keeps a press with Alt for itself.
    void aKeyPressedDuringTheDragCounts() {
        const std::vector<Vector<2>> before = vertices();
        const QPointF start = vertex(1);
        press(start);
        move(start + QPointF(30, 0));
        QCOMPARE(vertices()[0], before[0]);
        move(start + QPointF(30, 0), Qt::ControlModifier);
        QVERIFY(vertices()[0] != before[0]);
        move(start + QPointF(30, 5)); // let go of: still a rotation
        QVERIFY(vertices()[0] != before[0]);
        release(start + QPointF(30, 5));
        QVERIFY(m_document->undoStack()->undoText().startsWith(QStringLiteral("Rotate the cage ")));
        QCOMPARE(steps(), 1);
        m_document->undoStack()->undo();
        QVERIFY(vertices() == before);
    }

    void handlesDoTheSameWithoutKeys() {
        const Vector<2> pivot = m_canvas->canvas().handles().pivot();
        const std::vector<Vector<2>> before = vertices();
        drag(at({Kind::Rotate, 0}), {15, 60});
        QVERIFY(m_document->undoStack()->undoText().startsWith(QStringLiteral("Rotate the cage ")));
        QVERIFY(std::abs((vertices()[1] - pivot).norm() - (before[1] - pivot).norm()) < 1e-9);
        drag(at({Kind::Scale, 0}), {-30, -30});
        QVERIFY(m_document->undoStack()->undoText().startsWith(QStringLiteral("Scale the cage ")));
        QCOMPARE(steps(), 2);
    }

    void thePivotCanBePutElsewhere() {
        const QPoint start = at({Kind::Pivot, 0}).toPoint();
        drag(start, vertex(0) - start + QPoint(3, 3)); // near vertex 1, so on it
        QCOMPARE(m_canvas->canvas().handles().pivot(), vertices()[0]);
        QCOMPARE(steps(), 0);
        const Vector<2> pivot = m_canvas->canvas().handles().pivot();
        drag(inside(), {30, 0});
        QVERIFY(
            (m_canvas->canvas().handles().pivot() - pivot - view::worldOffset(m_canvas->camera(), {30, 0}))
                .norm() < 1e-12);
    }

    void tabWalksAndArrowsNudge() {
        for (int i = 0; i < 3; ++i) {
            QTest::keyClick(m_canvas.get(), Qt::Key_Tab);
            QCOMPARE(m_canvas->canvas().selection().focused(), (CanvasPart{Kind::Vertex, i}));
        }
        QTest::keyClick(m_canvas.get(), Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(m_canvas->canvas().selection().focused(), (CanvasPart{Kind::Vertex, 1}));
        const Vector<2> before = vertices()[1];
        const double pixel = 1 / m_canvas->camera().pixelsPerUnit;
        QTest::keyClick(m_canvas.get(), Qt::Key_Right);
        QVERIFY((vertices()[1] - before - Vector<2>(pixel, 0)).norm() < 1e-12);
        QTest::keyClick(m_canvas.get(), Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY((vertices()[1] - before - Vector<2>(pixel, 10 * pixel)).norm() < 1e-12);
        QTest::keyClick(m_canvas.get(), Qt::Key_Left, Qt::AltModifier);
        QVERIFY((vertices()[1] - before - Vector<2>(0.9 * pixel, 10 * pixel)).norm() < 1e-12);
        QCOMPARE(steps(), 1); // of one handle within a second
        QCOMPARE(undoText(),
                 QStringLiteral("Move vertex 2 to (%1, %2)")
                     .arg(view::shortNumber(vertices()[1].x()), view::shortNumber(vertices()[1].y())));
        m_document->undoStack()->undo();
        QCOMPARE(vertices()[1], before);
    }

    void aHeldArrowIsOneStep() {
        QTest::keyClick(m_canvas.get(), Qt::Key_Tab);
        const auto key = [&](QEvent::Type type, bool repeat) {
            QKeyEvent event(type, Qt::Key_Down, {}, {}, repeat);
            QCoreApplication::sendEvent(m_canvas.get(), &event);
        };
        const Vector<2> before = vertices()[0];
        key(QEvent::KeyPress, false);
        for (int i = 0; i < 9; ++i) {
            key(QEvent::KeyRelease, true);
            key(QEvent::KeyPress, true);
        }
        key(QEvent::KeyRelease, false);
        QCOMPARE(steps(), 1);
        QVERIFY((vertices()[0] - before - view::worldOffset(m_canvas->camera(), {0, 10})).norm() < 1e-12);
    }

    void snapsWhileDragging() {
        m_canvas->options().setSnapping(view::SnapTo::Axes);
        const QPointF target = view::pixelOf(m_canvas->camera(), {0, 0});
        drag(vertex(1), target - vertex(1) + QPointF(60, 5)); // near y = 0 only
        QCOMPARE(vertices()[1].y(), 0.0);
        QVERIFY(vertices()[1].x() != 0);
        m_canvas->options().setSnapping(view::SnapTo::Vertices);
        drag(vertex(2), vertex(0) - vertex(2) + QPointF(4, 4));
        QCOMPARE(vertices()[2], vertices()[0]);
    }

    void hidingTakesTheHandlesAway() {
        const QPoint handle = vertex(0);
        QSignalSpy spy(&m_canvas->options(), &view::CanvasOptions::overlaysVisibleChanged);
        QTest::keyClick(m_canvas.get(), Qt::Key_H);
        QCOMPARE(spy.count(), 1);
        hover(handle);
        QCOMPARE(cursor(), Qt::CrossCursor);
        drag(handle, {30, 30});
        QCOMPARE(steps(), 0);
        QTest::keyClick(m_canvas.get(), Qt::Key_H);
        hover(handle);
        QCOMPARE(cursor(), Qt::OpenHandCursor);
    }

    void readsOutBothCoordinates() {
        QSignalSpy spy(m_canvas.get(), &CanvasView::pointerMoved);
        hover(vertex(1));
        const auto position = spy.last().first().value<view::PointerPosition>();
        QVERIFY((position.world - vertices()[1]).norm() * m_canvas->camera().pixelsPerUnit < 1);
        QVERIFY(position.barycentric);
        QVERIFY((*position.barycentric - ifs::Barycentric<2>(0, 1, 0)).norm() < 0.02);
    }

    // The two vertices at the bottom, from the empty canvas beside them.
    void aRectangleSelectsVerticesThatMoveTogether() {
        std::vector<std::size_t> low{0, 1, 2};
        const auto height = [&](std::size_t index) { return vertex(int(index)).y(); };
        low.erase(std::ranges::min_element(low, {}, height));
        const QPoint one = vertex(int(low[0]));
        const QPoint other = vertex(int(low[1]));
        const QRect around = QRect(one, one).united(QRect(other, other)).adjusted(-16, -16, 16, 16);
        QCOMPARE(m_canvas->canvas().partAt(around.topLeft(), view::Reach::Mouse).kind, Kind::None);
        drag(around.topLeft(), around.bottomRight() - around.topLeft());
        QCOMPARE(scene().selection().vertices(), low);
        QCOMPARE(steps(), 0);

        const std::vector<Vector<2>> before = vertices();
        drag(one, {-20, 9});
        QVERIFY(undoText().startsWith(QStringLiteral("Move 2 vertices ")));
        QCOMPARE(steps(), 1);
        const Vector<2> offset = view::worldOffset(m_canvas->camera(), {-20, 9});
        for (std::size_t i = 0; i < 3; ++i) {
            const bool moved = std::ranges::find(low, i) != low.end();
            QVERIFY((vertices()[i] - before[i] - (moved ? offset : Vector<2>::Zero())).norm() < 1e-12);
        }
        QSignalSpy said(m_canvas.get(), &CanvasView::message);
        key(Qt::Key_Delete);
        QCOMPARE(vertices().size(), std::size_t{3});
        QVERIFY(said.last().first().toString().contains(QStringLiteral("at least three")));
        key(Qt::Key_Escape);
        QVERIFY(scene().selection().vertices().empty());
    }

    void keysInsertAndDeleteVertices() {
        const std::vector<Vector<2>> before = vertices();
        const QPointF edge = at({Kind::Edge, 1});
        hover(edge);
        key(Qt::Key_Insert);
        QCOMPARE(vertices().size(), std::size_t{4});
        QVERIFY(QLineF(at({Kind::Vertex, 2}), edge).length() < 1);
        QCOMPARE(scene().selection().focused(), (CanvasPart{Kind::Vertex, 2}));
        hover(empty());
        key(Qt::Key_Insert); // after the one in focus
        QCOMPARE(vertices().size(), std::size_t{5});
        QVERIFY((vertices()[3] - (vertices()[2] + vertices()[4]) / 2).norm() < 1e-12);
        click(vertex(2));
        click(vertex(3), Qt::ShiftModifier);
        QCOMPARE(scene().selection().vertices(), (std::vector<std::size_t>{2, 3}));
        key(Qt::Key_Delete);
        QCOMPARE(undoText(), QStringLiteral("Delete 2 vertices"));
        QCOMPARE(vertices(), before);
        QVERIFY(scene().selection().vertices().empty());
        m_document->undoStack()->undo();
        click(vertex(4));
        key(Qt::Key_Delete);
        QCOMPARE(undoText(), QStringLiteral("Delete vertex 5"));
    }

    // Another file may come while the pointer rests.
    void edgesThatAreGoneAreNotInserted() {
        QSignalSpy said(m_canvas.get(), &CanvasView::message);
        document::Fractal square = m_document->fractal();
        document::plane(square)->cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        document::Fractal space;
        space.shape = document::Shape<3>();
        for (const document::Fractal& next : {document::sierpinskiTriangle(), space}) {
            m_document->setFile(document::fileOf(square));
            m_canvas->fit();
            hover(at({Kind::Edge, 3}));
            QCOMPARE(scene().selection().hovered(), (CanvasPart{Kind::Edge, 3}));
            m_document->setFile(document::fileOf(next));
            key(Qt::Key_Insert);
            QCOMPARE(steps(), 0);
            QVERIFY(said.takeLast().first().toString().startsWith(QStringLiteral("To insert a corner")));
        }
    }

    void doubleClickOnAnEdgeInsertsAVertex() {
        const QPoint edge = at({Kind::Edge, 1}).toPoint();
        const auto before = vertices();
        QTest::mouseDClick(m_canvas->viewport(), Qt::LeftButton, {}, edge);
        QCOMPARE(steps(), 1);
        QCOMPARE(vertices().size(), std::size_t{4});
        QVERIFY((vertices()[2] - (before[1] + before[2]) / 2).norm() < 0.01 * (before[1] - before[2]).norm());
        const ifs::ControlCage<2> cage = *m_canvas->canvas().handles().cage();
        QVERIFY((cage.rest[2] - (cage.rest[1] + cage.rest[3]) / 2).norm() <
                0.01 * (cage.rest[1] - cage.rest[3]).norm());
        // The new vertex bends the picture, and one that folds it is warned of.
        drag(vertex(2), QPointF(25, -25));
        QVERIFY(ifs::bends(*document::plane(m_document->fractal())->cage));
        QVERIFY(document::bakeCage(*m_document).has_value());
        const QPointF across = (vertex(0) - vertex(2)) * 1.6;
        drag(vertex(2), across);
        QVERIFY2(m_canvas->note().contains(QStringLiteral("folded")), qPrintable(m_canvas->note()));
        QVERIFY(!document::removeVertices(*m_document, {2}));
        QCOMPARE(vertices().size(), std::size_t{3});
        QVERIFY(m_canvas->note().isEmpty());
        QVERIFY(document::removeVertices(*m_document, {2}).has_value());
    }

    void rewriteModeLeavesTheCageAtRest() {
        QVERIFY(m_canvas->note().isEmpty());
        m_document->setCageMode(document::CageMode::Rewrite);
        QVERIFY(!m_canvas->note().isEmpty()); // a sign that says so
        drag(vertex(1), QPointF(40, -30));
        const document::Fractal& fractal = m_document->fractal();
        QVERIFY(document::plane(fractal)->cage &&
                document::plane(fractal)->cage->rest == document::plane(fractal)->cage->current);
        QVERIFY(!(*document::system2(fractal) == *document::system2(document::sierpinskiTriangle())));
        QCOMPARE(steps(), 1);
        m_document->undoStack()->undo();
        QVERIFY(*document::system2(m_document->fractal()) ==
                *document::system2(document::sierpinskiTriangle()));
        m_document->setCageMode(document::CageMode::Place);
        QVERIFY(m_canvas->note().isEmpty());
    }

    void saysWhyThereIsNoPicture() {
        document::Fractal fractal = m_document->fractal();
        document::system2(fractal)->maps[1].map.linear *= 3;
        m_document->edit(QStringLiteral("Enlarge"), fractal);
        QTRY_VERIFY_WITH_TIMEOUT(m_canvas->note().contains(QStringLiteral("map 2")), 60'000);
        QVERIFY(m_canvas->note().contains(QStringLiteral("1.5")));
        m_document->undoStack()->undo();
        QTRY_VERIFY_WITH_TIMEOUT(m_canvas->note().isEmpty(), 60'000);
        fractal = m_document->fractal();
        for (auto& map : document::system2(fractal)->maps)
            map.weight = 0;
        m_document->edit(QStringLiteral("Weigh nothing"), fractal);
        QTRY_VERIFY_WITH_TIMEOUT(m_canvas->note().contains(QStringLiteral("positive weight")), 60'000);
        for (auto& map : document::system2(fractal)->maps)
            map.enabled = false;
        m_document->edit(QStringLiteral("Switch off"), fractal);
        QTRY_VERIFY_WITH_TIMEOUT(m_canvas->note().contains(QStringLiteral("switch one on")), 60'000);
    }

    void actionsKeepThePicture() {
        drag(vertex(2), {50, 20});
        const ifs::AffineMap<2> display = ifs::displayMap<2>(*document::plane(m_document->fractal())->cage);
        QVERIFY(!document::fitMinimalCanonicalSimplex(*m_document));
        const ifs::AffineMap<2> now = ifs::displayMap<2>(*document::plane(m_document->fractal())->cage);
        QVERIFY((now.linear - display.linear).norm() < 1e-9);
        QVERIFY(!document::bakeCage(*m_document));
        QVERIFY(document::plane(m_document->fractal())->cage->current ==
                document::plane(m_document->fractal())->cage->rest);
        QVERIFY(document::resetCage(*m_document).has_value()); // nothing to do, and it says so
        QCOMPARE(steps(), 3);
    }

    void whatIsWrongWithAVertexIsSeenWhole() {
        view::VertexDialog dialog(m_document.get(), 0, nullptr);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QLabel* problem = nullptr;
        for (auto* label : dialog.findChildren<QLabel*>())
            if (label->wordWrap()) problem = label;
        QVERIFY(problem);
        auto* y = dialog.findChildren<QLineEdit*>().last();
        y->setFocus();
        y->selectAll();
        QTest::keyClicks(y, QStringLiteral("abc"));
        QVERIFY(problem->text().contains(QStringLiteral("abc")));
        support::handleEvents();
        QVERIFY(problem->height() >= problem->heightForWidth(problem->width()));
        dialog.reject();
    }
};

BARYCAGE_TEST(CanvasTest, QApplication);
#include "canvas_test.moc"
