// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/thumbnails.h"

#include <QStyledItemDelegate>

class QAbstractItemModel;

namespace view {

// Pictures without a text, as large as their cells allow. The chosen one lies on a tile of the colour of
// selections; the one in focus and the one under the pointer have a frame.
class PictureTiles : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    static constexpr int margin = 6;                    // pixels around a picture
    static constexpr int chosenRole = Qt::UserRole + 1; // true: chosen without being selected

    static void show(QAbstractItemModel* model, const QModelIndex& index, const Thumbnail& thumbnail);
    static Thumbnail shown(const QModelIndex& index);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

} // namespace view
