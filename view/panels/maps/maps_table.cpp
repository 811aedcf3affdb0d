// SPDX-License-Identifier: MIT
#include "panels/maps/maps_table.h"

#include "panels/maps/cell_steps.h"
#include "panels/maps/maps_model.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>

namespace view {

MapsTable::MapsTable(QWidget* parent) : QTableView(parent) {
    QFont small = font(); // smaller, for seven columns of numbers in a narrow panel
    small.setPointSizeF(small.pointSizeF() * 0.92);
    setFont(small);
    setTabKeyNavigation(false); // Tab goes on to the fields below; in an editor, to the next cell
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    setSelectionBehavior(SelectRows);
    setSelectionMode(ExtendedSelection);
    setHorizontalScrollMode(ScrollPerPixel);
    setShowGrid(false);
    setAlternatingRowColors(true);
    setWordWrap(false);
    setCornerButtonEnabled(false);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setMinimumHeight(120);
    viewport()->setMouseTracking(true);
    QHeaderView* header = horizontalHeader();
    header->setFont(small);
    header->setMinimumSectionSize(18); // pixels of the column of locks
    header->setHighlightSections(false);
    header->setResizeContentsPrecision(50); // rows in addition to the visible ones
    header->setSectionResizeMode(QHeaderView::Interactive);
    header->setWhatsThis(
        tr("Drag the name of a number left or right to change it in the current map: a tenth as fast with "
           "Shift, ten times as fast with Ctrl. The wheel does the same while the pointer is over the "
           "current cell. Drag the edge of a name to change the width of its column."));
    connect(new CellSteps(this), &CellSteps::refused, this, &MapsTable::refused);
}

QItemSelection MapsTable::selectionOf(std::vector<int> rows) const {
    std::ranges::sort(rows);
    QItemSelection selection; // as few ranges as possible
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const int top = rows[i];
        while (i + 1 < rows.size() && rows[i + 1] <= rows[i] + 1)
            ++i;
        selection.select(model()->index(top, 0), model()->index(rows[i], model()->columnCount() - 1));
    }
    return selection;
}

bool MapsTable::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
    const auto* maps = qobject_cast<MapsModel*>(model());
    if (maps && (trigger & editTriggers())) {
        const QString obstacle = maps->editObstacle(index);
        if (!obstacle.isEmpty()) emit refused(obstacle);
    }
    return QTableView::edit(index, trigger, event);
}

// Characters with which a number or an expression may begin start the edit of a cell, whatever the window
// does with that key: digits, and the letters of cos, exp, ln, pi, sqrt and tan.
bool MapsTable::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool plain = !(key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
        const bool isNumber = currentIndex().flags() & Qt::ItemIsEditable;
        const QString beginnings =
            QStringLiteral("0123456789+-.,(") + (isNumber ? QStringLiteral("celpst") : QString());
        if (plain && key->text().size() == 1 && beginnings.contains(key->text())) event->accept();
    }
    return QTableView::event(event);
}

bool MapsTable::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::MouseMove)
        emit rowPointed(indexAt(static_cast<QMouseEvent*>(event)->position().toPoint()).row());
    if (event->type() == QEvent::Leave) emit rowPointed(-1);
    return QTableView::viewportEvent(event);
}

} // namespace view
