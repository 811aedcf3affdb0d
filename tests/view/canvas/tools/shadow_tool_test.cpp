// SPDX-License-Identifier: MIT
#include "view/canvas/canvas_fixture.h"

#include "canvas/items/shadow_item.h"
#include "document/edits/shadow_edits.h"
#include "support/named_test.h"

#include <QTest>

// The tip of a shadow on the canvas, under the mouse.
class ShadowToolTest : public CanvasFixture {
    Q_OBJECT

private:
    void castShadow() {
        m_document->edit(QStringLiteral("shadow"), document::withShadow(m_document->fractal(), true));
    }
    const attractor::Appearance& look() const { return m_document->fractal().appearance; }
    QPointF knob() const { return scene().knobs().shadow.knob().value_or(QPointF(-100, -100)); }

private slots:
    void init() { open(); }
    void cleanup() { close(); }

    void onlyAShadowHasAHandle() {
        QVERIFY(!scene().knobs().shadow.knob());
        castShadow();
        QVERIFY(scene().knobs().shadow.knob());
        m_document->undoStack()->undo();
        QVERIFY(!scene().knobs().shadow.knob());
    }

    void aDragIsOneStep() {
        castShadow();
        const int before = steps();
        const double lean = look().shadowLean, length = look().shadowLength;
        const QPointF from = knob(), by(40, 30);
        hover(from);
        QCOMPARE(cursor(), Qt::OpenHandCursor);
        press(from);
        move(from + by / 2);
        QVERIFY(look().shadowLean > lean && look().shadowLength < length); // live
        QCOMPARE(cursor(), Qt::ClosedHandCursor);
        QCOMPARE(steps(), before);
        move(from + by);
        release(from + by);
        QCOMPARE(steps(), before + 1);
        QVERIFY((knob() - (from + by)).manhattanLength() < 1e-6);
        m_document->undoStack()->undo();
        QCOMPARE(look().shadowLean, lean);
        QCOMPARE(look().shadowLength, length);
    }

    void escCancels() {
        castShadow();
        const int before = steps();
        const double lean = look().shadowLean;
        const QPointF from = knob();
        press(from);
        move(from + QPointF(50, 20));
        QVERIFY(look().shadowLean != lean);
        key(Qt::Key_Escape);
        QCOMPARE(look().shadowLean, lean);
        release(from + QPointF(50, 20));
        QCOMPARE(steps(), before);
    }

    void aClickMovesNothing() {
        castShadow();
        const int before = steps();
        click(knob() + QPointF(2, 1));
        QCOMPARE(steps(), before);
    }

    // A vertex under the tip can still be taken.
    void aVertexComesFirst() {
        castShadow();
        const auto stick = document::shadowStick(m_document->fractal(), scene().camera().yAxis);
        QVERIFY(stick);
        const Vector<2> vertex = vertices().at(1);
        m_document->edit(QStringLiteral("turn"),
                         document::withShadowTip(m_document->fractal(), *stick, vertex));
        const double lean = look().shadowLean;
        const QPointF from = knob();
        press(from);
        move(from + QPointF(30, -20));
        release(from + QPointF(30, -20));
        QCOMPARE(look().shadowLean, lean);
        QVERIFY(vertices().at(1) != vertex);
    }
};

BARYCAGE_TEST(ShadowToolTest, QApplication);
#include "shadow_tool_test.moc"
