// SPDX-License-Identifier: MIT
#pragma once

#include <QTableView>

namespace view {

// The table of numbers of the Maps panel: quiet, narrow, and edited as soon as a digit is typed on a cell.
class MapsTable : public QTableView {
    Q_OBJECT

public:
    explicit MapsTable(QWidget* parent = nullptr);

signals:
    void rowPointed(int row); // by the pointer; −1: none

protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
};

} // namespace view
