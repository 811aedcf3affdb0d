// SPDX-License-Identifier: MIT
#include "dialogs/variations/picture_tiles.h"

#include "widgets/thumbnail_tile.h"

#include <QPainter>

#include <algorithm>

namespace view {

namespace {

constexpr int stateRole = Qt::UserRole;

} // namespace

void PictureTiles::show(QAbstractItemModel* model, const QModelIndex& index, const Thumbnail& thumbnail) {
    model->setData(index, int(thumbnail.state), stateRole);
    model->setData(index, thumbnail.pixmap, Qt::DecorationRole);
}

Thumbnail PictureTiles::shown(const QModelIndex& index) {
    return {static_cast<Thumbnail::State>(index.data(stateRole).toInt()),
            index.data(Qt::DecorationRole).value<QPixmap>()};
}

void PictureTiles::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
    const QRect cell = option.rect;
    const int side = std::min(cell.width(), cell.height()) - 2 * margin;
    QRect picture(0, 0, side, side);
    picture.moveCenter(cell.center());
    const QRect tile = picture.adjusted(1 - margin, 1 - margin, margin - 1, margin - 1);
    const QColor highlight = option.palette.color(QPalette::Highlight);
    const bool isFramed =
        option.state.testFlag(QStyle::State_HasFocus) || option.state.testFlag(QStyle::State_MouseOver);
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter->setPen(isFramed ? QPen(highlight, 1) : QPen(Qt::NoPen));
    const bool isChosen = option.state.testFlag(QStyle::State_Selected) || index.data(chosenRole).toBool();
    painter->setBrush(isChosen ? QBrush(highlight) : QBrush(Qt::NoBrush));
    painter->drawRoundedRect(QRectF(tile).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    paintThumbnail(*painter, picture, shown(index), option.palette);
    painter->restore();
}

} // namespace view
