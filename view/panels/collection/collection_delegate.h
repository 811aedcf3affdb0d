// SPDX-License-Identifier: MIT
#pragma once

#include <QFont>
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
    struct Heights { // of a line of text; every entry of a long list asks for them
        QFont font;
        int name = 0;
        int heading = 0;
    };
    const Heights& heights(const QFont& font) const;
    void paintHeading(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
    void paintEntry(QPainter* painter, QStyleOptionViewItem option, const QModelIndex& index) const;

    mutable Heights m_heights;
};

} // namespace view
