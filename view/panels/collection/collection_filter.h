// SPDX-License-Identifier: MIT
#pragma once

#include <QSortFilterProxyModel>

namespace view {

// Entries that contain every word searched for (and are favourites, when only these are wanted), and the
// titles of themes that have such entries. Rows come and go all at once: one by one, long lists would take
// long.
class CollectionFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setWords(const QString& words);
    void setOnlyFavourites(bool only);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    bool isWanted(const QModelIndex& entry) const;

    QStringList m_words;
    bool m_onlyFavourites = false;
};

} // namespace view
