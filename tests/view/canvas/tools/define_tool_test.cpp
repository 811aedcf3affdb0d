// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"

#include <QAbstractButton>
#include <QMessageBox>
#include <QSignalSpy>

class DefineToolTest : public CanvasFixture {
    Q_OBJECT

private slots:
    void init() { open(); }
    void cleanup() { close(); }

    void threeClicksDefineTheTriangle() {
        drag(vertex(2), {40, 10});
        QTRY_VERIFY_WITH_TIMEOUT(m_bridge->isCurrent(), 60'000);
        const ifs::AffineMap<2> display = ifs::displayMap<2>(*document::plane(m_document->fractal())->cage);
        QSignalSpy changed(m_canvas.get(), &CanvasView::toolChanged);
        m_canvas->setTool(CanvasView::Tool::DefineTriangle);
        QCOMPARE(cursor(), Qt::CrossCursor);
        click({100, 100});
        click({150, 150});
        QTest::keyClick(m_canvas.get(), Qt::Key_Backspace);
        click({400, 120});
        QSignalSpy refused(m_canvas.get(), &CanvasView::message);
        click({250, 110}); // on the line of the other two
        QCOMPARE(refused.count(), 1);
        QCOMPARE(steps(), 1);
        click({300, 400});
        QCOMPARE(m_canvas->tool(), CanvasView::Tool::Cage);
        QCOMPARE(changed.count(), 2);
        QCOMPARE(steps(), 2);
        QCOMPARE(vertex(0), QPoint(100, 100));
        QCOMPARE(vertex(1), QPoint(400, 120));
        QCOMPARE(vertex(2), QPoint(300, 400));
        // The picture stays: the display map is the same.
        const ifs::AffineMap<2> now = ifs::displayMap<2>(*document::plane(m_document->fractal())->cage);
        QVERIFY((now.linear - display.linear).norm() < 1e-9);
        QVERIFY((now.translation - display.translation).norm() < 1e-9);
    }

    void definingCanBeLeft() {
        m_canvas->setTool(CanvasView::Tool::DefineTriangle);
        click({100, 100});
        QTest::keyClick(m_canvas.get(), Qt::Key_Escape);
        QCOMPARE(m_canvas->tool(), CanvasView::Tool::Cage);
        QCOMPARE(steps(), 0);
        m_canvas->setTool(CanvasView::Tool::DefineTriangle);
        click({100, 100});
        QContextMenuEvent menu(QContextMenuEvent::Mouse, {50, 50},
                               m_canvas->viewport()->mapToGlobal(QPoint(50, 50)));
        QCoreApplication::sendEvent(m_canvas->viewport(), &menu);
        QCOMPARE(m_canvas->tool(), CanvasView::Tool::Cage);
        QCOMPARE(steps(), 0);
    }

    void definingOnAFlatCageOffersReset() {
        document::Fractal flat = m_document->fractal();
        document::plane(flat)->cage = document::effectiveCage(flat);
        document::plane(flat)->cage->current[2] =
            (document::plane(flat)->cage->current[0] + document::plane(flat)->cage->current[1]) / 2;
        m_document->edit(QStringLiteral("Flatten"), flat);
        m_canvas->setTool(CanvasView::Tool::DefineTriangle);
        QCOMPARE(m_canvas->tool(), CanvasView::Tool::Cage);
        auto* question = m_canvas->findChild<QMessageBox*>();
        QVERIFY(question);
        for (QAbstractButton* button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::AcceptRole) button->click();
        QCOMPARE(m_canvas->tool(), CanvasView::Tool::DefineTriangle);
        QVERIFY(document::plane(m_document->fractal())->cage->current ==
                document::plane(m_document->fractal())->cage->rest);
    }
};

BARYCAGE_TEST(DefineToolTest, QApplication);
#include "define_tool_test.moc"
