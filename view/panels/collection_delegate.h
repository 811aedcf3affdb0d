// SPDX-License-Identifier: MIT
#pragma once

#include <QStyledItemDelegate>

namespace view {

// Draws a theme's title across the whole width, and each of its entries as a picture with its name below.
class CollectionDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int pictureSide = 76; // device-independent pixels

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    void paintHeading(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
    void paintEntry(QPainter* painter, QStyleOptionViewItem option, const QModelIndex& index) const;
};

} // namespace view
