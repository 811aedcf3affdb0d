// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"

#include <QColor>

#include <cmath>

// What lies over each other on the canvas: which is taken, and what is seen.
class HandlesInTheWayTest : public CanvasFixture {
    Q_OBJECT

private slots:
    void init() { open(); }
    void cleanup() { close(); }

    // Also where it is nearer to the pointer.
    void thePivotNeverWinsOverAVertex() {
        const QPointF beside = at({Kind::Vertex, 0}) + QPointF(9, 0);
        drag(at({Kind::Pivot, 0}), beside - at({Kind::Pivot, 0}), Qt::NoModifier);
        const document::Fractal before = m_document->fractal();
        QCOMPARE(steps(), 0);
        hover(beside);
        QCOMPARE(scene().selection().hovered(), (CanvasPart{Kind::Vertex, 0}));
        drag(beside, {25, -10});
        QVERIFY(m_document->fractal() != before);
        QCOMPARE(steps(), 1);
    }

    // Between the lines of a flat cage the picture is seen as if there were no cage.
    void aFlatAttractorIsNotHiddenByItsCage() {
        const Vector<2> middle = (vertices()[0] + vertices()[1]) / 2;
        drag(vertex(2), view::pixelOf(m_canvas->camera(), middle) - at({Kind::Vertex, 2}));
        m_canvas->fit();
        const auto isFinished = [this] { // with as many samples as there will be
            return m_bridge->isCurrent() && m_bridge->frame()->samples >= m_bridge->quality();
        };
        QTRY_VERIFY(isFinished());
        const QPointF start = at({Kind::Vertex, 0}), end = at({Kind::Vertex, 1});
        const QImage with = m_canvas->viewport()->grab().toImage();
        key(Qt::Key_H);
        QTRY_VERIFY(isFinished());
        const QImage without = m_canvas->viewport()->grab().toImage();
        int same = 0, shown = 0;
        const QRgb ground = without.pixel(4, 4);
        for (double t = 0.08; t < 0.92; t += 0.005) {
            if (std::abs(t - 0.5) < 0.1) continue; // where the third handle lies
            const QPoint p = (start + t * (end - start)).toPoint();
            shown += without.pixel(p) != ground;
            const QColor a(with.pixel(p)), b(without.pixel(p)); // the picture is refined meanwhile
            same += std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                        std::abs(a.blue() - b.blue()) <
                    120;
        }
        QVERIFY2(shown > 60, qPrintable(QString::number(shown)));
        QVERIFY2(same > 60, // of which a line over it leaves a few
                 qPrintable(QString::number(same)));
    }
};

BARYCAGE_TEST(HandlesInTheWayTest, QApplication);
#include "handles_in_the_way_test.moc"
