// SPDX-License-Identifier: MIT
#include "panels/maps/cell_steps.h"

#include "document/edits/maps/map_locks.h"
#include "panels/maps/maps_panel.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"

#include <QApplication>
#include <QHeaderView>
#include <QMouseEvent>
#include <QTableView>
#include <QWheelEvent>

#include <array>
#include <memory>

using namespace maps_support;
using view::MapsModel;

// Numbers in the table of maps, changed by the wheel and by their names. The number is d of map 2: 0.31.
class CellStepsTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() {
        m_panel.reset();
        m_document.reset();
    }

    void theWheelChangesTheCurrentCell();
    void theWheelScrollsElsewhere();
    void theNameOfAColumnIsDragged();
    void escapeTakesTheDragBack();
    void columnsAreResizedAtTheirEdges();
    void lockedMapsStay();

private:
    static constexpr int row = 1, column = MapsModel::D;
    QTableView& table() { return *m_panel->table(); }
    QWidget& names() { return *table().horizontalHeader()->viewport(); }
    int steps() { return m_document->undoStack()->count(); }
    double number() { return systemOf(*m_document).maps[row].map.linear(1, 1); }
    void roll(int atRow, int angle, Qt::KeyboardModifiers modifiers = {});
    QPoint nameAt(int fromRight);
    void mouse(QEvent::Type type, const QPoint& at);

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<view::MapsPanel> m_panel;
};

void CellStepsTest::init() {
    m_document = std::make_unique<document::Document>();
    m_document->setFile(document::fileOf(withTriangle(maple())));
    m_panel = std::make_unique<view::MapsPanel>(m_document.get());
    m_panel->resize(480, 600);
    m_panel->show();
    m_panel->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    table().setCurrentIndex(m_panel->model()->index(row, column));
    table().setFocus();
    QVERIFY(table().hasFocus());
    QCOMPARE(number(), 0.31);
}

void CellStepsTest::roll(int atRow, int angle, Qt::KeyboardModifiers modifiers) {
    const QModelIndex cell = m_panel->model()->index(atRow, column);
    const QPoint at = table().visualRect(cell).center();
    QCOMPARE(table().indexAt(at), cell);
    QWheelEvent event(at, table().viewport()->mapToGlobal(at), {}, {0, angle}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(table().viewport(), &event);
}

QPoint CellStepsTest::nameAt(int fromRight) {
    const QHeaderView& header = *table().horizontalHeader();
    return {header.sectionViewportPosition(column) + header.sectionSize(column) - fromRight,
            header.height() / 2};
}

void CellStepsTest::mouse(QEvent::Type type, const QPoint& at) {
    const bool isMove = type == QEvent::MouseMove;
    QMouseEvent event(type, at, names().mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&names(), &event);
}

void CellStepsTest::theWheelChangesTheCurrentCell() {
    for (int i = 0; i < 3; ++i)
        roll(row, 120);
    QCOMPARE(number(), 0.34);
    QCOMPARE(steps(), 1);
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Set d of map 2 to 0.34"));
    m_document->undoStack()->undo();
    QVERIFY(number() == 0.31);
    roll(row, 60); // half a step of a fine wheel
    QVERIFY(number() == 0.31);
    roll(row, 60);
    QCOMPARE(number(), 0.32);
    roll(row, -120, Qt::ShiftModifier);
    QCOMPARE(number(), 0.319);
    roll(row, 240, Qt::ControlModifier);
    QCOMPARE(number(), 0.519);
}

void CellStepsTest::theWheelScrollsElsewhere() {
    roll(row + 1, 120);
    QCOMPARE(steps(), 0);
    table().setCurrentIndex(m_panel->model()->index(row, MapsModel::E));
    roll(row, 120);
    QCOMPARE(steps(), 0);
    table().setCurrentIndex(m_panel->model()->index(row, column));
    table().clearFocus();
    roll(row, 120);
    QCOMPARE(steps(), 0);
}

void CellStepsTest::theNameOfAColumnIsDragged() {
    const std::vector<ifs::MapId> selected = m_panel->selectedMaps();
    const int width = table().columnWidth(column);
    const QPoint at = nameAt(width / 2);
    mouse(QEvent::MouseButtonPress, at);
    mouse(QEvent::MouseMove, at + QPoint(20, 0));
    QCOMPARE(number(), 0.36); // seen at once
    QCOMPARE(steps(), 0);
    mouse(QEvent::MouseMove, at + QPoint(8, 3));
    mouse(QEvent::MouseButtonRelease, at + QPoint(8, 3));
    QCOMPARE(number(), 0.33);
    QCOMPARE(steps(), 1);
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Set d of map 2 to 0.33"));
    QCOMPARE(table().columnWidth(column), width);
    QVERIFY(m_panel->selectedMaps() == selected);
    m_document->undoStack()->undo();
    QVERIFY(number() == 0.31);
}

void CellStepsTest::escapeTakesTheDragBack() {
    const QPoint at = nameAt(table().columnWidth(column) / 2);
    mouse(QEvent::MouseButtonPress, at);
    mouse(QEvent::MouseMove, at + QPoint(20, 0));
    QVERIFY(number() != 0.31);
    QTest::keyClick(&table(), Qt::Key_Escape);
    QVERIFY(number() == 0.31);
    mouse(QEvent::MouseMove, at + QPoint(40, 0));
    mouse(QEvent::MouseButtonRelease, at + QPoint(40, 0));
    QVERIFY(number() == 0.31);
    QCOMPARE(steps(), 0);
}

void CellStepsTest::columnsAreResizedAtTheirEdges() {
    const int width = table().columnWidth(column);
    const QPoint at = nameAt(2);
    mouse(QEvent::MouseButtonPress, at);
    mouse(QEvent::MouseMove, at + QPoint(12, 0));
    mouse(QEvent::MouseButtonRelease, at + QPoint(12, 0));
    QVERIFY(table().columnWidth(column) > width);
    QCOMPARE(steps(), 0);
}

void CellStepsTest::lockedMapsStay() {
    const std::array<ifs::MapId, 1> map{m_panel->model()->idAt(row)};
    document::lockMaps(*m_document, map, true);
    const int before = steps();
    QStringList said;
    connect(m_panel.get(), &view::MapsPanel::message, this, [&](const QString& text) { said << text; });
    roll(row, 120);
    const QPoint at = nameAt(table().columnWidth(column) / 2);
    mouse(QEvent::MouseButtonPress, at);
    mouse(QEvent::MouseMove, at + QPoint(20, 0));
    mouse(QEvent::MouseButtonRelease, at + QPoint(20, 0));
    QCOMPARE(number(), 0.31);
    QCOMPARE(steps(), before);
    QCOMPARE(said.size(), 1);
    QVERIFY(said[0].contains(QStringLiteral("locked")));
}

BARYCAGE_TEST(CellStepsTest, QApplication);
#include "cell_steps_test.moc"
