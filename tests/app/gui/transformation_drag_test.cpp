// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"
#include "stage/stage.h"
#include "support/commands.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "transformation/transformation_view.h"
#include "window_fixture.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>

using Kind = view::CanvasPart::Kind;

// Maps of F under the mouse while a fractal transformation is shown.
class TransformationDragTest : public WindowFixture {
    Q_OBJECT

private slots:
    void draggingAMapIsLiveAndOneStep();
};

void TransformationDragTest::draggingAMapIsLiveAndOneStep() {
    support::command(*m_window, "fractal-transformation")->trigger();
    support::action(*m_window, "triangle-family")->trigger();
    const auto* transformation = m_window->findChild<view::TransformationView*>();
    view::CanvasView* canvas = m_window->findChild<Stage*>()->plane();
    QTRY_VERIFY_WITH_TIMEOUT(transformation->isPainted(), 60'000);
    canvas->setTool(view::CanvasView::Tool::Maps);
    document::Document& document = m_window->document();
    const document::Fractal before = document.fractal();
    const int steps = document.undoStack()->count();
    QWidget* target = canvas->viewport();
    QTRY_VERIFY_WITH_TIMEOUT(!canvas->canvas().frames().empty(), 60'000);
    const QPoint from = canvas->canvas().positionOf({Kind::Vertex, 0, 0}).toPoint(); // of the first map
    QTRY_VERIFY_WITH_TIMEOUT(!canvas->picture().isNull(), 60'000);
    const QImage still = canvas->picture();
    QTest::mousePress(target, Qt::LeftButton, {}, from);
    for (int k = 1; k <= 12; ++k) {
        const QPoint to = from + QPoint(4 * k, -3 * k);
        QMouseEvent move(QEvent::MouseMove, to, target->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(target, &move);
        QCoreApplication::processEvents();
    }
    QTRY_VERIFY_WITH_TIMEOUT(canvas->picture() != still, 60'000);
    QVERIFY(document.fractal() != before);
    QCOMPARE(document.undoStack()->count(), steps);
    QTest::mouseRelease(target, Qt::LeftButton, {}, from + QPoint(48, -36));
    QCOMPARE(document.undoStack()->count(), steps + 1);
    document.undoStack()->undo();
    QVERIFY(document.fractal() == before);
}

BARYCAGE_TEST(TransformationDragTest, QApplication);
#include "transformation_drag_test.moc"
