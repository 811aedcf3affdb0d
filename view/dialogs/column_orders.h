// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/table_columns.h"

#include <QStringList>
#include <QWidget>

class QComboBox;
class QLineEdit;

namespace view {

// The orders of columns that programs and books use, the most usual first; at the end any other, which is
// typed.
class ColumnOrders : public QWidget {
    Q_OBJECT

public:
    ColumnOrders(const QString& whatsThis, QWidget* parent);

    io::TableColumns columns() const; // Fractint's order while the text is none
    QString obstacle() const;         // reason why the text is no order, as a sentence; empty if it is one

    QStringList known() const; // names of the columns, as in "a b c d e f p"
    void choose(const QString& order);
    void chooseCumulative(); // Fractint's order, with cumulative weights
    bool isFractints() const;

signals:
    void changed();

private:
    QComboBox* m_known;
    QLineEdit* m_typed;
};

} // namespace view
