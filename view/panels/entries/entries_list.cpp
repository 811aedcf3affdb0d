// SPDX-License-Identifier: MIT
#include "panels/entries/entries_list.h"

#include "desktop/clipboard.h"
#include "panels/entries/entries_model.h"

#include <QDrag>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QPainter>
#include <QSet>

#include <algorithm>
#include <utility>
#include <vector>

namespace view {

using document::EntryId;

EntriesList::EntriesList(MimeSource mimeSource, QWidget* parent)
    : QListView(parent), m_mimeSource(std::move(mimeSource)) {
    setUniformItemSizes(true);
    setVerticalScrollMode(ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSelectionMode(ExtendedSelection);
    setEditTriggers(EditKeyPressed | DoubleClicked); // no editing by a click that merely takes the focus
    setDragEnabled(true);
    setAcceptDrops(true);
    setDragDropMode(DragDrop);
    setDropIndicatorShown(false); // painted here, between the rows
    setContextMenuPolicy(Qt::CustomContextMenu);
}

QList<EntryId> EntriesList::selectedIds() const {
    std::vector<int> rows;
    for (const QItemSelectionRange& range : selectionModel()->selection())
        for (int row = range.top(); row <= range.bottom(); ++row)
            rows.push_back(row);
    std::ranges::sort(rows);
    QList<EntryId> ids;
    ids.reserve(qsizetype(rows.size()));
    for (const int row : rows)
        ids.append(idAtRow(row));
    return ids;
}

void EntriesList::select(const QList<EntryId>& ids) {
    const QSet<EntryId> wanted(ids.begin(), ids.end());
    QItemSelection selection; // as few ranges as possible
    const int rows = model()->rowCount();
    qsizetype missing = wanted.size();
    for (int first = 0; first < rows && missing > 0; ++first) {
        int behind = first;
        while (behind < rows && wanted.contains(idAtRow(behind)))
            ++behind;
        if (behind == first) continue;
        missing -= behind - first;
        selection.select(model()->index(first, 0), model()->index(behind - 1, 0));
        first = behind;
    }
    selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
}

void EntriesList::setEmptyText(const QString& text) {
    m_emptyText = text;
    viewport()->update();
}

// Goes on to the next name, unless the new name has taken the entry out of the filter.
void EntriesList::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
    const bool isNext = hint == QAbstractItemDelegate::EditNextItem;
    const bool goesOn = isNext || hint == QAbstractItemDelegate::EditPreviousItem;
    QListView::closeEditor(editor, goesOn ? QAbstractItemDelegate::NoHint : hint);
    if (!goesOn) return;
    const QModelIndex before = currentIndex();
    setCurrentIndex(moveCursor(isNext ? MoveNext : MovePrevious, Qt::NoModifier));
    const QModelIndex now = currentIndex();
    if (now != before && now.flags() & Qt::ItemIsEditable) QListView::edit(now);
}

void EntriesList::startDrag(Qt::DropActions) {
    const QList<EntryId> ids = selectedIds();
    if (ids.isEmpty()) return;
    auto* drag = new QDrag(this); // deleted by Qt at the end of the drag
    drag->setMimeData(m_mimeSource(ids).release());
    drag->setPixmap(currentIndex().data(Qt::DecorationRole).value<QPixmap>());
    drag->exec(Qt::CopyAction | Qt::MoveAction, Qt::CopyAction);
}

void EntriesList::dragEnterEvent(QDragEnterEvent* event) {
    QListView::dragEnterEvent(event);
    offer(event);
}

void EntriesList::dragMoveEvent(QDragMoveEvent* event) {
    QListView::dragMoveEvent(event); // scrolls at the edges
    showDropRow(offer(event) ? rowBelow(event->position().toPoint()) : -1);
}

void EntriesList::dragLeaveEvent(QDragLeaveEvent* event) {
    QListView::dragLeaveEvent(event);
    showDropRow(-1);
}

void EntriesList::dropEvent(QDropEvent* event) {
    if (offer(event)) {
        const EntryId before = idAtRow(rowBelow(event->position().toPoint()));
        if (event->source() == this)
            emit entriesDropped(selectedIds(), before);
        else
            emit dataDropped(*event->mimeData(), before);
    }
    finishDrag();
}

void EntriesList::paintEvent(QPaintEvent* event) {
    QListView::paintEvent(event);
    QPainter painter(viewport());
    if (model()->rowCount() == 0) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(viewport()->rect().adjusted(16, 24, -16, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         m_emptyText);
    }
    if (m_dropRow >= 0) {
        const int rows = model()->rowCount();
        const QRect last = visualRect(model()->index(rows - 1, 0));
        const int y = m_dropRow < rows ? visualRect(model()->index(m_dropRow, 0)).top() : last.bottom() + 1;
        painter.fillRect(QRect(0, std::max(0, y - 1), viewport()->width(), 2),
                         palette().color(QPalette::Highlight));
    }
}

EntryId EntriesList::idAtRow(int row) const {
    return static_cast<EntryId>(model()->index(row, 0).data(EntriesModel::IdRole).toUInt());
}

int EntriesList::rowBelow(const QPoint& position) const {
    const QModelIndex index = indexAt(position);
    if (!index.isValid()) return model()->rowCount();
    return index.row() + (position.y() > visualRect(index).center().y() ? 1 : 0);
}

bool EntriesList::offer(QDropEvent* event) const {
    const bool own = event->source() == this;
    if (!own && !mayHoldEntries(*event->mimeData())) {
        event->ignore();
        return false;
    }
    event->setDropAction(own ? Qt::MoveAction : Qt::CopyAction);
    event->accept();
    return true;
}

void EntriesList::showDropRow(int row) {
    if (row == m_dropRow) return;
    m_dropRow = row;
    viewport()->update();
}

void EntriesList::finishDrag() {
    stopAutoScroll();
    setState(NoState);
    showDropRow(-1);
}

} // namespace view
