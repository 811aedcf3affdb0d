// SPDX-License-Identifier: MIT
#include "panels/appearance/palettes/palette_filter.h"

#include <algorithm>

namespace view {

void PaletteFilter::setWords(const QString& words) {
    m_words = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
}

void PaletteFilter::setOnlyFavourites(bool only) {
    m_onlyFavourites = only;
    invalidateFilter();
}

bool PaletteFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    if (m_onlyFavourites && !index.data(favouriteRole).toBool()) return false;
    const QString text = index.data().toString() + QLatin1Char(' ') + index.data(nameRole).toString();
    return std::all_of(m_words.begin(), m_words.end(),
                       [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace view
