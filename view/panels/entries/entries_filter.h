// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QSet>
#include <QSortFilterProxyModel>

namespace view {

// Entries whose name has the text, and those that have been shown since it was typed. Rows come and go all at
// once: one by one, long lists would take long.
class EntriesFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setText(const QString& text);
    void setShown(document::EntryId id); // entry on the canvas, which always passes

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QString m_text;
    QSet<document::EntryId> m_kept;
    document::EntryId m_shown = document::EntryId::None;
};

} // namespace view
