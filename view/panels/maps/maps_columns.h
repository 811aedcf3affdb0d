// SPDX-License-Identifier: MIT
#pragma once

#include "panels/maps/maps_model.h"

class QTableView;

namespace view {

// The widths of the columns of the table of maps. Code and weight fit the width of the table: names become
// shorter first, then the numbers have fewer decimals, but never fewer than three digits, then these are
// drawn narrower. Further columns are scrolled to.
class MapsColumns : public QObject {
    Q_OBJECT

public:
    MapsColumns(QTableView* table, MapsModel* model);

    void fit(); // fits the columns to the present numbers; not during a drag

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    int widthOf(int column) const;
    int available() const;

    QTableView* m_table;
    MapsModel* m_model;
};

} // namespace view
