// SPDX-License-Identifier: MIT
#include "panels/entries_filter.h"

namespace view {

void EntriesFilter::setText(const QString& text) {
    if (text == m_text) return;
    m_text = text;
    invalidate();
}

bool EntriesFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    return m_text.isEmpty() ||
           sourceModel()->index(row, 0, parent).data().toString().contains(m_text, Qt::CaseInsensitive);
}

} // namespace view
