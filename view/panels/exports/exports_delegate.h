// SPDX-License-Identifier: MIT
#pragma once

#include <QStyledItemDelegate>

namespace view {

// A row of the queue: the file, how far it is in words, and a bar while it is drawn.
class ExportsDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

} // namespace view
