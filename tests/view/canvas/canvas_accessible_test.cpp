// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "view/canvas/canvas_fixture.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QScopeGuard>

// The canvas for screen readers and by keyboard.
class CanvasAccessibleTest : public CanvasFixture {
    Q_OBJECT

private slots:
    void init() { open(); }
    void cleanup() { close(); }

    void screenReadersSeeTheHandles() {
        QAccessible::setActive(true);
        QAccessibleInterface* canvas = QAccessible::queryAccessibleInterface(m_canvas.get());
        QVERIFY(canvas);
        QCOMPARE(canvas->childCount(), 7);
        QCOMPARE(canvas->child(1)->text(QAccessible::Name), QStringLiteral("Vertex 2"));
        QVERIFY(canvas->child(1)->text(QAccessible::Value).startsWith(QStringLiteral("x ")));
        QCOMPARE(canvas->child(1)->rect().center() - QPoint(-1, -1),
                 m_canvas->viewport()->mapToGlobal(vertex(1)));
        QTest::keyClick(m_canvas.get(), Qt::Key_Tab);
        QVERIFY(canvas->child(0)->state().focused);
        QVERIFY(!canvas->child(1)->state().focused);
        const QString before = canvas->child(0)->text(QAccessible::Value);
        QTest::keyClick(m_canvas.get(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(canvas->child(0)->text(QAccessible::Value) != before);
        QCOMPARE(canvas->indexOfChild(canvas->child(2)), 2);
    }

    void screenReadersMoveTheHandles() {
        QAccessibleInterface* canvas = QAccessible::queryAccessibleInterface(m_canvas.get());
        QVERIFY(canvas);
        QAccessibleActionInterface* actions = canvas->child(1)->actionInterface();
        QVERIFY(actions);
        QCOMPARE(actions->actionNames().size(), 5);
        const QPoint before = vertex(1);
        actions->doAction(QAccessibleActionInterface::setFocusAction());
        QVERIFY(canvas->child(1)->state().focused);
        QCOMPARE(vertex(1), before);
        for (int i = 0; i < 8; ++i)
            actions->doAction(QStringLiteral("moveLeft"));
        QVERIFY(vertex(1).x() < before.x());
        QCOMPARE(vertex(1).y(), before.y());
        QVERIFY(steps() >= 1);
        QCOMPARE(actions->localizedActionName(QStringLiteral("moveUp")), QStringLiteral("Move up"));
    }

    void tabLeavesAfterTheLastHandle() {
        QWidget window;
        auto* row = new QHBoxLayout(&window);
        auto* before = new QLineEdit(&window);
        auto* after = new QLineEdit(&window);
        for (QWidget* widget : std::initializer_list<QWidget*>{before, m_canvas.get(), after})
            row->addWidget(widget);
        const auto alone = qScopeGuard([this] { m_canvas->setParent(nullptr); });
        QWidget::setTabOrder(before, m_canvas.get());
        QWidget::setTabOrder(m_canvas.get(), after);
        window.resize(800, 500);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        m_canvas->setFocus();
        int handles = 0;
        for (; m_canvas->hasFocus() && handles < 20; ++handles)
            QTest::keyClick(m_canvas.get(), Qt::Key_Tab);
        QCOMPARE(handles, int(m_canvas->canvas().handles().parts().size()) + 1);
        QCOMPARE(window.focusWidget(), after);
        QCOMPARE(m_canvas->canvas().selection().focused().kind, Kind::None);
        m_canvas->setFocus(); // back: the last handle is the first that is met
        QTest::keyClick(m_canvas.get(), Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(m_canvas->canvas().selection().focused(), m_canvas->canvas().handles().parts().back());
        for (int i = 1; i < handles; ++i)
            QTest::keyClick(m_canvas.get(), Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(window.focusWidget(), before);
    }
};

BARYCAGE_TEST(CanvasAccessibleTest, QApplication);
#include "canvas_accessible_test.moc"
