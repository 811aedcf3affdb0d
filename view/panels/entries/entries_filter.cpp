// SPDX-License-Identifier: MIT
#include "panels/entries/entries_filter.h"

#include "panels/entries/entries_model.h"

namespace view {

void EntriesFilter::setText(const QString& text) {
    if (text == m_text) return;
    m_text = text;
    m_kept = {m_shown};
    invalidate();
}

// The row shown before stays, too: it would go from under a double click.
void EntriesFilter::setShown(document::EntryId id) {
    if (id == m_shown) return;
    m_shown = id;
    if (m_kept.contains(id)) return;
    m_kept.insert(id);
    if (!m_text.isEmpty()) invalidateFilter();
}

bool EntriesFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    if (m_text.isEmpty()) return true;
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    return m_kept.contains(static_cast<document::EntryId>(index.data(EntriesModel::IdRole).toUInt())) ||
           index.data().toString().contains(m_text, Qt::CaseInsensitive);
}

} // namespace view
