// SPDX-License-Identifier: MIT
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>

namespace view {

// Palettes whose title or English name contains every word searched for, and which are favourites where only
// these are wanted.
class PaletteFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    static constexpr int nameRole = Qt::UserRole; // English name
    static constexpr int favouriteRole = Qt::UserRole + 1;

    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setWords(const QString& words);
    void setOnlyFavourites(bool only);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QStringList m_words;
    bool m_onlyFavourites = false;
};

} // namespace view
