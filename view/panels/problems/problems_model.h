// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QAbstractTableModel>
#include <QList>

namespace view {

// Problems that the reader found in the open file and the entries still in it, in the order of their lines.
class ProblemsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Place, EntryName, Message, ColumnCount };

    explicit ProblemsModel(document::Document* document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    int attentionCount() const;               // number of rows that are more than remarks
    document::EntryId entryAt(int row) const; // None: the file as a whole
    const document::Problem& problemAt(int row) const { return m_rows[row].problem; }

private:
    struct Row {
        document::EntryId entry = document::EntryId::None;
        document::Problem problem;
        friend bool operator==(const Row&, const Row&) = default;
    };

    QList<Row> collect() const;
    void refresh();

    document::Document* m_document;
    QList<Row> m_rows;
};

} // namespace view
