// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/export_queue.h"

#include <QAbstractListModel>

namespace view {

// The queue of exports as a list, for every window.
class ExportsModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        IdRole = Qt::UserRole,
        StateRole,    // int of QueuedExport::State
        SentenceRole, // QString: progress in words
        ProgressRole, // double: 0 … 1 while the export is drawn; else invalid
        PathRole,
    };

    explicit ExportsModel(ExportQueue* queue, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    QString sentence(const QueuedExport& one) const;

    ExportQueue* m_queue;
};

} // namespace view
