// SPDX-License-Identifier: MIT
#include "view/canvas/canvas_fixture.h"

#include "canvas/items/symmetry_item.h"
#include "document/edits/maps/symmetry_edits.h"
#include "support/named_test.h"

#include <QTest>

// The centre of a symmetry on the canvas, under the mouse.
class SymmetryToolTest : public CanvasFixture {
    Q_OBJECT

private:
    void makeSymmetric() {
        m_document->edit(
            QStringLiteral("symmetric"),
            document::withSymmetry(m_document->fractal(),
                                   ifs::Symmetry<2>{ifs::SymmetryGroup::Rotation, 5, 0, {0.5, 0.25}}));
    }
    const Vector<2>& centre() const { return system().symmetry.centre; }
    QPointF knob() const { return scene().knobs().symmetry.knob().value_or(QPointF(-100, -100)); }

private slots:
    void init() { open(); }
    void cleanup() { close(); }

    void onlyASymmetryHasAHandle() {
        QVERIFY(!scene().knobs().symmetry.knob());
        makeSymmetric();
        QVERIFY(scene().knobs().symmetry.knob());
        m_document->undoStack()->undo();
        QVERIFY(!scene().knobs().symmetry.knob());
    }

    void aDragIsOneStep() {
        makeSymmetric();
        const int before = steps();
        const QPointF from = knob(), by(60, -30);
        const std::vector<Vector<2>> cage = vertices();
        hover(from);
        QCOMPARE(cursor(), Qt::OpenHandCursor);
        press(from);
        move(from + by / 2);
        QVERIFY(centre() != Vector<2>(0.5, 0.25)); // live
        QCOMPARE(cursor(), Qt::ClosedHandCursor);
        QCOMPARE(steps(), before);
        move(from + by);
        release(from + by);
        QCOMPARE(steps(), before + 1);
        const double scale = scene().camera().pixelsPerUnit;
        QVERIFY((centre() - Vector<2>(0.5 + 60 / scale, 0.25 + 30 / scale)).norm() < 1e-9);
        QVERIFY((knob() - (from + by)).manhattanLength() < 1e-6);
        m_document->undoStack()->undo();
        QCOMPARE(centre(), Vector<2>(0.5, 0.25));
    }

    void escCancels() {
        makeSymmetric();
        const int before = steps();
        const QPointF from = knob();
        press(from);
        move(from + QPointF(50, 50));
        key(Qt::Key_Escape);
        QCOMPARE(centre(), Vector<2>(0.5, 0.25));
        move(from + QPointF(80, 50));
        release(from + QPointF(80, 50));
        QCOMPARE(centre(), Vector<2>(0.5, 0.25));
        QCOMPARE(steps(), before);
    }

    void aClickMovesNothing() {
        makeSymmetric();
        const int before = steps();
        click(knob() + QPointF(2, 1));
        QCOMPARE(steps(), before);
    }

    // Under a cage the handle is where the centre is seen, and goes where the pointer goes.
    void underACage() {
        makeSymmetric();
        document::Fractal fractal = m_document->fractal();
        ifs::ControlCage<2> cage;
        cage.rest = {{0, 0}, {1, 0}, {0, 1}};
        cage.current = {{0, 0}, {1, 0.3}, {-0.2, 0.8}};
        document::plane(fractal)->cage = cage;
        m_document->edit(QStringLiteral("cage"), fractal);
        const QPointF from = knob(), by(-40, 20);
        drag(from, by);
        QVERIFY((knob() - (from + by)).manhattanLength() < 1e-6);
        QVERIFY((centre() - Vector<2>(0.5, 0.25)).norm() > 1e-3);
    }

    void whateverToolIsInUse() {
        makeSymmetric();
        m_canvas->setTool(CanvasView::Tool::Maps);
        const QPointF from = knob();
        drag(from, {20, 20});
        QVERIFY(centre() != Vector<2>(0.5, 0.25));
        key(Qt::Key_H);
        QVERIFY(!scene().knobs().symmetry.knob());
    }
};

BARYCAGE_TEST(SymmetryToolTest, QApplication);
#include "symmetry_tool_test.moc"
