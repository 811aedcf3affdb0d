// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QAbstractItemDelegate>
#include <QList>
#include <QListView>

#include <functional>
#include <memory>

namespace view {

// The list itself: selection, drag and drop, and what it says when it is empty. It edits nothing; what was
// dropped is reported with the entry in front of which it fell (None: behind the last one).
class EntriesList : public QListView {
    Q_OBJECT

public:
    using MimeSource = std::function<std::unique_ptr<QMimeData>(const QList<document::EntryId>& ids)>;

    EntriesList(MimeSource mimeSource, QWidget* parent);

    QList<document::EntryId> selectedIds() const; // order of the list
    void select(const QList<document::EntryId>& ids);
    void setEmptyText(const QString& text);
    bool isEditing() const { return state() == EditingState; } // true while a name is being edited

signals:
    void entriesDropped(const QList<document::EntryId>& ids, document::EntryId before);
    void dataDropped(const QMimeData& mimeData, document::EntryId before);

protected:
    void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
    void startDrag(Qt::DropActions actions) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    document::EntryId idAtRow(int row) const;
    int rowBelow(const QPoint& position) const; // row before which a drop would be inserted
    bool offer(QDropEvent* event) const;
    void showDropRow(int row);
    void finishDrag();

    MimeSource m_mimeSource;
    QString m_emptyText;
    int m_dropRow = -1;
};

} // namespace view
