// SPDX-License-Identifier: MIT
#include "panels/collection/collection_filter.h"

#include "panels/collection/collection_model.h"

#include <algorithm>

namespace view {

void CollectionFilter::setWords(const QString& words) {
    m_words = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidate();
}

void CollectionFilter::setOnlyFavourites(bool only) {
    m_onlyFavourites = only;
    invalidate();
}

bool CollectionFilter::filterAcceptsRow(int row, const QModelIndex&) const {
    if (m_words.isEmpty() && !m_onlyFavourites) return true;
    const QModelIndex index = sourceModel()->index(row, 0);
    if (!index.data(CollectionModel::HeadingRole).toBool()) return isWanted(index);
    for (int below = row + 1; below < sourceModel()->rowCount(); ++below) {
        const QModelIndex entry = sourceModel()->index(below, 0);
        if (entry.data(CollectionModel::HeadingRole).toBool()) return false;
        if (isWanted(entry)) return true;
    }
    return false;
}

bool CollectionFilter::isWanted(const QModelIndex& entry) const {
    if (m_onlyFavourites && !entry.data(CollectionModel::FavouriteRole).toBool()) return false;
    const QString text = entry.data(CollectionModel::SearchRole).toString();
    return std::all_of(m_words.begin(), m_words.end(),
                       [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace view
