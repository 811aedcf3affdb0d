// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "ifs/system/links.h"

#include <QAbstractTableModel>
#include <QColor>

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

    // The same by rows, for the graph.
    const std::vector<double>& matrix() const { return m_matrix; }
    double weight(int from, int to) const {
        return m_matrix[std::size_t(from) * m_states.size() + std::size_t(to)];
    }
    void setWeight(int from, int to, double weight); // one undo step; none if nothing changes
    void forbid(const QModelIndexList& cells);       // one undo step; ignores cells of the last column
    ifs::LinkState state(int map) const { return m_states[std::size_t(map)]; }
    QString reason(int map) const; // role of the map, or reason why it has none
    QColor colour(int map) const;

signals:
    void refused(const QString& reason); // reason why the typed text is invalid

private:
    bool isState(int column) const { return column == rowCount(); }
    double weight(const QModelIndex& index) const { return weight(index.row(), index.column()); }
    void reload();

    document::Document* m_document;
    std::vector<double> m_matrix; // row by row
    std::vector<ifs::LinkState> m_states;
};

} // namespace view
