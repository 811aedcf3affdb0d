// SPDX-License-Identifier: MIT
#include "panels/snapshots/snapshot_delegate.h"

#include "widgets/thumbnail_tile.h"

#include <QApplication>
#include <QLineEdit>
#include <QPainter>

namespace view {

namespace {

constexpr int padding = 6;
constexpr int gap = 4;
constexpr int pillSide = 16;

QRect pictureOf(const QRect& tile) {
    return {tile.left() + (tile.width() - SnapshotDelegate::pictureSide) / 2, tile.top() + padding,
            SnapshotDelegate::pictureSide, SnapshotDelegate::pictureSide};
}

QRect nameOf(const QRect& tile) {
    const int top = pictureOf(tile).bottom() + gap;
    return {tile.left() + 3, top, tile.width() - 6, tile.bottom() - top};
}

// Paints the mark in the corner of the picture, whatever the picture is.
void paintPill(QPainter& painter, const QRect& picture, const QStyleOptionViewItem& option) {
    const QRectF pill(picture.right() - pillSide - 1, picture.top() + 3, pillSide, pillSide);
    painter.setPen(Qt::NoPen);
    painter.setBrush(option.palette.color(QPalette::Highlight));
    painter.drawEllipse(pill);
    QFont bold = option.font;
    bold.setBold(true);
    bold.setPixelSize(11);
    painter.setFont(bold);
    painter.setPen(option.palette.color(QPalette::HighlightedText));
    painter.drawText(pill, Qt::AlignCenter, QStringLiteral("B"));
}

void paintFrame(QPainter& painter, const QRect& picture, const QStyleOptionViewItem& option) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(option.palette.color(QPalette::Highlight), 2));
    painter.drawRoundedRect(QRectF(picture).adjusted(-2, -2, 2, 2), Thumbnails::cornerRadius + 2,
                            Thumbnails::cornerRadius + 2);
}

} // namespace

void SnapshotDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                             const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const bool isSelected = option.state & QStyle::State_Selected;
    const bool isUnderPointer = option.state & QStyle::State_MouseOver;
    const bool isShown = index.data(ShownRole).toBool();
    const QRect picture = pictureOf(option.rect);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (isSelected || isUnderPointer) { // quiet, because the frame marks the one that is shown
        QColor tint = option.palette.color(QPalette::Text);
        tint.setAlphaF(isSelected ? 0.14F : 0.07F);
        painter->setPen(Qt::NoPen);
        painter->setBrush(tint);
        painter->drawRoundedRect(QRectF(option.rect).adjusted(1, 1, -1, -1), 5, 5);
    }
    paintThumbnail(*painter, picture,
                   {static_cast<Thumbnail::State>(index.data(StateRole).toInt()),
                    index.data(Qt::DecorationRole).value<QPixmap>()},
                   option.palette);
    if (isShown) paintFrame(*painter, picture, option);
    if (index.data(MarkedRole).toBool()) paintPill(*painter, picture, option);
    QFont font = option.font;
    font.setBold(isShown);
    painter->setFont(font);
    painter->setPen(option.palette.color(QPalette::Text));
    const QRect name = nameOf(option.rect);
    painter->drawText(
        name, Qt::AlignHCenter | Qt::AlignVCenter,
        QFontMetrics(font).elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideRight, name.width()));
    painter->restore();
}

QSize SnapshotDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    const int letters = QFontMetrics(option.font).averageCharWidth();
    return {qMax(pictureSide + 2 * padding + 4, 14 * letters),
            padding + pictureSide + gap + QFontMetrics(option.font).height() + 4};
}

QWidget* SnapshotDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                        const QModelIndex&) const {
    auto* editor = new QLineEdit(parent);
    editor->setAccessibleName(tr("Name of the snapshot"));
    editor->setAutoFillBackground(true);
    editor->setMaxLength(60);
    return editor;
}

void SnapshotDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                            const QModelIndex&) const {
    QRect line = nameOf(option.rect);
    const int missing = editor->minimumSizeHint().height() - line.height();
    if (missing > 0) line.adjust(0, -missing, 0, 0); // never below the strip
    editor->setGeometry(line);
}

} // namespace view
