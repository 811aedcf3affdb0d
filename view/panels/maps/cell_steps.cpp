// SPDX-License-Identifier: MIT
#include "panels/maps/cell_steps.h"

#include "panels/maps/maps_model.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QTableView>
#include <QWheelEvent>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace view {

namespace {

constexpr double stepSize = 0.01;
constexpr double pixelsPerStep = 4;

MapsModel* modelOf(const QTableView* table) {
    return qobject_cast<MapsModel*>(table->model());
}

bool isEscape(const QEvent& event) {
    return (event.type() == QEvent::ShortcutOverride || event.type() == QEvent::KeyPress) &&
           static_cast<const QKeyEvent&>(event).key() == Qt::Key_Escape;
}

// The kind of the turns of the wheel over one cell that become one step.
int turnsOf(const MapsModel& model, const QModelIndex& cell) {
    return int(qHashMulti(1, int(model.idAt(cell.row())), cell.column()) & std::numeric_limits<int>::max());
}

} // namespace

CellSteps::CellSteps(QTableView* table) : QObject(table), m_table(table), m_names(table->horizontalHeader()) {
    m_table->viewport()->installEventFilter(this);
    m_names->viewport()->installEventFilter(this);
}

bool CellSteps::eventFilter(QObject* watched, QEvent* event) {
    // The parts of the table send more when they are destroyed, after it has ceased to be one.
    if (!m_isHeld && !event->isInputEvent()) return false;
    if (!modelOf(m_table)) return false;
    if (m_isHeld && isEscape(*event)) {
        event->accept();
        return event->type() == QEvent::ShortcutOverride || end(End::Cancel);
    }
    if (watched == m_names->viewport()) return drag(*event);
    return watched == m_table->viewport() && event->type() == QEvent::Wheel &&
           turn(static_cast<QWheelEvent&>(*event));
}

bool CellSteps::turn(const QWheelEvent& event) {
    const QModelIndex cell = m_table->currentIndex();
    MapsModel& model = *modelOf(m_table);
    if (!m_table->hasFocus() || !cell.isValid() || !model.isEditable(cell.column()) ||
        !model.editObstacle(cell).isEmpty() || m_table->indexAt(event.position().toPoint()) != cell)
        return false;
    if (m_turned != cell) m_wheelRest = 0;
    m_turned = cell;
    // Alt turns the wheel sideways on some platforms.
    const QPoint delta = event.angleDelta();
    m_wheelRest += std::abs(delta.y()) >= std::abs(delta.x()) ? delta.y() : delta.x();
    const int count = m_wheelRest / QWheelEvent::DefaultDeltasPerStep;
    m_wheelRest -= count * QWheelEvent::DefaultDeltasPerStep;
    if (count != 0) {
        step(cell, count, event.modifiers(), turnsOf(model, cell));
        commit(cell);
    }
    return true;
}

void CellSteps::step(const QModelIndex& cell, int count, Qt::KeyboardModifiers modifiers, int kind) {
    if (!cell.isValid()) return; // map removed
    const double next = stepped(cell.data(Qt::EditRole).toDouble(), stepSize * paceOfSteps(modifiers), count);
    if (numberProblem(fullNumber(next)).isEmpty()) modelOf(m_table)->preview(cell, next, kind);
}

void CellSteps::commit(const QModelIndex& cell) {
    MapsModel& model = *modelOf(m_table);
    model.commitEdit();
    if (const QString remark = model.remark(cell); !remark.isEmpty()) emit refused(remark);
}

bool CellSteps::drag(QEvent& event) {
    switch (event.type()) {
    case QEvent::MouseButtonPress:
        return press(static_cast<QMouseEvent&>(event));
    case QEvent::MouseMove:
        return move(static_cast<QMouseEvent&>(event));
    case QEvent::MouseButtonRelease:
        return end(End::Commit);
    case QEvent::Hide:
        end(End::Commit);
        return false;
    default:
        return false;
    }
}

QModelIndex CellSteps::cellNamedAt(int x) const {
    const MapsModel& model = *modelOf(m_table);
    const int column = m_names->logicalIndexAt(x);
    const int row = m_table->currentIndex().row();
    if (row < 0 || column < 0 || !model.isEditable(column)) return {};
    const int grip = m_names->style()->pixelMetric(QStyle::PM_HeaderGripMargin, nullptr, m_names);
    const int left = m_names->sectionViewportPosition(column);
    const bool isAtEdge = x < left + grip || x >= left + m_names->sectionSize(column) - grip;
    return isAtEdge ? QModelIndex() : model.index(row, column);
}

bool CellSteps::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    const QModelIndex cell = cellNamedAt(event.position().toPoint().x());
    if (!cell.isValid()) return false;
    if (const QString locked = modelOf(m_table)->editObstacle(cell); !locked.isEmpty()) {
        emit refused(locked);
        return true;
    }
    m_held = cell;
    m_last = event.globalPosition().x();
    m_rest = 0;
    m_isHeld = true;
    QCoreApplication::instance()->installEventFilter(this); // for Esc, wherever the focus is
    return true;
}

bool CellSteps::move(const QMouseEvent& event) {
    if (!m_isHeld) {
        const bool isOverName =
            event.buttons() == Qt::NoButton && cellNamedAt(event.position().toPoint().x()).isValid();
        if (isOverName)
            m_names->viewport()->setCursor(Qt::SizeHorCursor);
        else
            m_names->viewport()->unsetCursor();
        return false;
    }
    m_rest += (event.globalPosition().x() - m_last) / pixelsPerStep;
    m_last = event.globalPosition().x();
    const double whole = std::trunc(m_rest);
    m_rest -= whole;
    if (whole != 0) step(m_held, int(whole), event.modifiers(), -1);
    return true;
}

bool CellSteps::end(End how) {
    if (!m_isHeld) return false;
    m_isHeld = false;
    QCoreApplication::instance()->removeEventFilter(this);
    if (how == End::Commit)
        commit(m_held);
    else
        modelOf(m_table)->cancelEdit();
    return true;
}

} // namespace view
