// SPDX-License-Identifier: MIT
#pragma once

#include <QItemSelection>
#include <QTableView>

#include <vector>

namespace view {

// The table of numbers of the Maps panel: quiet, narrow, and edited as soon as a digit is typed on a cell.
class MapsTable : public QTableView {
    Q_OBJECT

public:
    explicit MapsTable(QWidget* parent = nullptr);
    using QTableView::edit;

    QItemSelection selectionOf(std::vector<int> rows) const; // all cells of the rows

signals:
    void rowPointed(int row);            // row under the pointer; −1: none
    void refused(const QString& reason); // sent after an attempt to edit a locked cell

protected:
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
};

} // namespace view
