// SPDX-License-Identifier: MIT
#pragma once

#include <QFont>
#include <QPersistentModelIndex>
#include <QPixmap>
#include <QStyledItemDelegate>

namespace view {

// Draws a theme's title across the whole width, and each of its entries as a picture with its name below. One
// entry may show another picture: the frame of its animation.
class CollectionDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    // The side of the pictures, in device-independent pixels.
    CollectionDelegate(int pictureSide, QObject* parent);

    int pictureSide() const { return m_side; }
    void setFrame(const QModelIndex& index, const QPixmap& frame); // invalid index: no entry

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    struct Heights { // heights of lines of text, cached because a long list needs them for every entry
        QFont font;
        int name = 0;
        int heading = 0;
    };
    const Heights& heights(const QFont& font) const;
    void paintHeading(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
    void paintEntry(QPainter* painter, QStyleOptionViewItem option, const QModelIndex& index) const;

    QFont nameFont(const QFont& font) const;

    int m_side;
    mutable Heights m_heights;
    QPersistentModelIndex m_moving;
    QPixmap m_frame;
};

} // namespace view
