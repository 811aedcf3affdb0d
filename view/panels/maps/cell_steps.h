// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPersistentModelIndex>

class QHeaderView;
class QMouseEvent;
class QTableView;
class QWheelEvent;

namespace view {

// Changes numbers in the table of maps whose cells are not being edited, in the steps of number fields. The
// wheel changes the current cell while the pointer is over it and the table has the focus; turns that follow
// each other closely are one undo step. The name of a column, dragged left or right, changes the number of
// the current map: one undo step, or none after Esc.
class CellSteps : public QObject {
    Q_OBJECT

public:
    explicit CellSteps(QTableView* table); // table of a MapsModel

signals:
    void refused(const QString& reason); // message that the map is locked, or switched off by its new weight

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool turn(const QWheelEvent& event);
    bool drag(QEvent& event);
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    enum class End { Commit, Cancel };
    bool end(End how);
    void commit(const QModelIndex& cell);
    void step(const QModelIndex& cell, int count, Qt::KeyboardModifiers modifiers, int kind);
    // The number of the current map under its name at x; none near the edges, where columns are resized.
    QModelIndex cellNamedAt(int x) const;

    QTableView* m_table;
    QHeaderView* m_names;
    QPersistentModelIndex m_turned; // cell turned by the wheel
    int m_wheelRest = 0;            // eighths of a degree not yet worth a step
    QPersistentModelIndex m_held;   // cell whose name is being dragged
    bool m_isHeld = false;
    double m_last = 0; // last position of the pointer in pixels
    double m_rest = 0; // steps not yet taken
};

} // namespace view
