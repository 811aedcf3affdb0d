// SPDX-License-Identifier: MIT
#pragma once

#include "document/edit_gesture.h"
#include "document/edits/maps/maps_edits.h"
#include "io/table/table_reader.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTableWidget;

namespace view {

class ColumnOrders;

// Rows of numbers that do not say which column is which: the user chooses, and sees the maps in the table of
// the dialog and their picture on the canvas until it is right. One step of the history, or none.
class PasteTableDialog : public QDialog {
    Q_OBJECT

public:
    // Replaces the maps in `rows`; appends new ones when there are none. The fractal must hold a plane
    // system.
    PasteTableDialog(document::Document* document, const document::Rows& rows, const QString& text,
                     QWidget* parent = nullptr);

    // Asks what the columns are of a table that has become the current entry, in the order of Fractint.
    // Another order is a step of the history.
    static void askForColumns(document::Document* document, const QString& table, QWidget* parent);

    int count() const { return int(m_table.rows.size()); } // number of maps in the present reading

signals:
    void pasted(const std::vector<ifs::MapId>& touched);

protected:
    void done(int result) override;

private:
    void guess();
    void update();

    QString m_text;
    document::Rows m_rows;
    document::EditGesture m_gesture;
    io::Table m_table;
    std::vector<ifs::MapId> m_touched;
    ColumnOrders* m_columns;
    QTableWidget* m_maps;
    QLabel* m_verdict;
    QPushButton* m_accept = nullptr;
};

} // namespace view
