// SPDX-License-Identifier: MIT
#include "panels/collection/collection_filter.h"

#include "panels/collection/collection_model.h"

#include <algorithm>

namespace view {

void CollectionFilter::setSourceModel(QAbstractItemModel* model) {
    QSortFilterProxyModel::setSourceModel(model);
    // Titles appear and vanish with their entries.
    connect(model, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex&, const QModelIndex&, const QList<int>& roles) {
                if ((m_part == Part::Favourites && roles.contains(CollectionModel::FavouriteRole)) ||
                    (m_part == Part::Recent && roles.contains(CollectionModel::RecentRole)))
                    invalidate();
            });
}

void CollectionFilter::setWords(const QString& words) {
    m_words = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidate();
}

void CollectionFilter::setPart(Part part, const QString& section) {
    m_part = part;
    m_section = section;
    sort(part == Part::Recent ? 0 : -1);
    invalidate();
}

bool CollectionFilter::filterAcceptsRow(int row, const QModelIndex&) const {
    const QModelIndex index = sourceModel()->index(row, 0);
    if (!index.data(CollectionModel::HeadingRole).toBool()) return isWanted(index);
    if (!hasTitles()) return false;
    if (m_words.isEmpty() && m_part == Part::All) return true;
    for (int below = row + 1; below < sourceModel()->rowCount(); ++below) {
        const QModelIndex entry = sourceModel()->index(below, 0);
        if (entry.data(CollectionModel::HeadingRole).toBool()) return false;
        if (isWanted(entry)) return true;
    }
    return false;
}

bool CollectionFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    return left.data(CollectionModel::RecentRole).toInt() < right.data(CollectionModel::RecentRole).toInt();
}

bool CollectionFilter::isInPart(const QModelIndex& entry) const {
    switch (m_part) {
    case Part::Favourites:
        return entry.data(CollectionModel::FavouriteRole).toBool();
    case Part::Recent:
        return entry.data(CollectionModel::RecentRole).toInt() >= 0;
    case Part::Theme:
        return entry.data(CollectionModel::SectionRole) == m_section;
    case Part::All:
        break;
    }
    return true;
}

bool CollectionFilter::isWanted(const QModelIndex& entry) const {
    if (!isInPart(entry)) return false;
    if (m_words.isEmpty()) return true;
    const QString text = entry.data(CollectionModel::SearchRole).toString();
    return std::all_of(m_words.begin(), m_words.end(),
                       [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace view
