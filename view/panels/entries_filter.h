// SPDX-License-Identifier: MIT
#pragma once

#include <QSortFilterProxyModel>

namespace view {

// Entries whose name has the text. Rows come and go all at once: one by one, long lists would take long.
class EntriesFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setText(const QString& text);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QString m_text;
};

} // namespace view
