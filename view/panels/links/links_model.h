// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "ifs/system/links.h"

#include <QAbstractTableModel>

#include <vector>

namespace view {

// The matrix of links of the entry being edited: a row for the map applied before, a column for the one
// after, and last what becomes of the map of the row. Empty where maps cannot be linked.
class LinksModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit LinksModel(document::Document* document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value,
                 int role = Qt::EditRole) override; // one undo step
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void refused(const QString& reason); // what was typed

private:
    bool isState(int column) const { return column == rowCount(); }
    double weight(const QModelIndex& index) const;
    void reload();

    document::Document* m_document;
    std::vector<double> m_matrix; // by rows
    std::vector<ifs::LinkState> m_states;
};

} // namespace view
