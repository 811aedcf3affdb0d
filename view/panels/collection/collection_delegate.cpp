// SPDX-License-Identifier: MIT
#include "panels/collection/collection_delegate.h"

#include "panels/collection/collection_model.h"
#include "widgets/thumbnail_tile.h"

#include <QApplication>
#include <QListView>
#include <QPainter>

#include <cmath>
#include <numbers>

namespace view {
namespace {

constexpr int padding = 4;
constexpr int smallSide = 100; // pixels; smaller pictures have smaller names

QFont headingFont(const QFont& font) {
    QFont bold = font;
    bold.setBold(true);
    return bold;
}

// Golden with a dark edge: to be seen on any picture.
void paintStar(QPainter* painter, const QRect& picture) {
    constexpr double radius = 7;
    const QPointF centre(picture.right() - radius - 3, picture.top() + radius + 3);
    QPolygonF star;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::numbers::pi * (i / 5.0 - 0.5);
        const double reach = i % 2 == 0 ? radius : 0.45 * radius;
        star << centre + reach * QPointF(std::cos(angle), std::sin(angle));
    }
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(QColor(0x3a, 0x2a, 0x00), 1));
    painter->setBrush(QColor(0xff, 0xcc, 0x33));
    painter->drawPolygon(star);
    painter->restore();
}

// A white triangle on a dark disk, for what moves.
void paintPlay(QPainter* painter, const QRect& picture) {
    constexpr double radius = 9;
    const QPointF centre(picture.right() - radius - 4, picture.bottom() - radius - 4);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(QColor(255, 255, 255, 110), 1));
    painter->setBrush(QColor(0, 0, 0, 150));
    painter->drawEllipse(centre, radius, radius);
    painter->setPen(Qt::NoPen);
    painter->setBrush(Qt::white);
    painter->drawPolygon(
        QPolygonF{centre + QPointF(-3, -4.5), centre + QPointF(5, 0), centre + QPointF(-3, 4.5)});
    painter->restore();
}

bool isHeading(const QModelIndex& index) {
    return index.data(CollectionModel::HeadingRole).toBool();
}

} // namespace

CollectionDelegate::CollectionDelegate(int pictureSide, QObject* parent)
    : QStyledItemDelegate(parent), m_side(pictureSide) {}

void CollectionDelegate::setFrame(const QModelIndex& index, const QPixmap& frame) {
    m_moving = index;
    m_frame = frame;
}

QFont CollectionDelegate::nameFont(const QFont& font) const {
    QFont smaller = font;
    if (m_side < smallSide && font.pointSizeF() > 0) smaller.setPointSizeF(font.pointSizeF() * 0.86);
    return smaller;
}

void CollectionDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
    painter->save();
    if (isHeading(index))
        paintHeading(painter, option, index);
    else
        paintEntry(painter, option, index);
    painter->restore();
}

QSize CollectionDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const auto* list = qobject_cast<const QListView*>(option.widget);
    const int spacing = list ? list->spacing() : 0;
    const int room = list ? list->viewport()->width() - spacing - 1 : 200;
    if (isHeading(index))
        return {qMax(room - spacing, m_side), heights(option.font).heading + 4 * padding}; // alone in its row
    const int least = m_side + 2 * padding;
    const int columns = qMax(1, room / (least + spacing));
    return {qMax(least, room / columns - spacing), m_side + 3 * padding + heights(option.font).name};
}

const CollectionDelegate::Heights& CollectionDelegate::heights(const QFont& font) const {
    if (m_heights.name == 0 || m_heights.font != font)
        m_heights = {font, QFontMetrics(nameFont(font)).height(), QFontMetrics(headingFont(font)).height()};
    return m_heights;
}

void CollectionDelegate::paintHeading(QPainter* painter, const QStyleOptionViewItem& option,
                                      const QModelIndex& index) const {
    const QFont font = headingFont(option.font);
    const QRect text = option.rect.adjusted(padding, 2 * padding, -padding, -padding);
    painter->setFont(font);
    painter->setPen(option.palette.color(QPalette::Active, QPalette::Text));
    painter->drawText(
        text, static_cast<int>(Qt::AlignBottom | QStyle::visualAlignment(option.direction, Qt::AlignLeft)),
        QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, text.width()));
}

void CollectionDelegate::paintEntry(QPainter* painter, QStyleOptionViewItem option,
                                    const QModelIndex& index) const {
    option.showDecorationSelected = true; // behind both picture and name
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, option.widget);

    const QRect picture(option.rect.left() + (option.rect.width() - m_side) / 2, option.rect.top() + padding,
                        m_side, m_side);
    const bool isMoving = m_moving == index && !m_frame.isNull();
    const Thumbnail still{
        static_cast<Thumbnail::State>(index.data(CollectionModel::ThumbnailStateRole).toInt()),
        index.data(Qt::DecorationRole).value<QPixmap>()};
    paintThumbnail(*painter, picture, isMoving ? Thumbnail{Thumbnail::State::Ready, m_frame} : still,
                   option.palette);
    if (!isMoving && m_side >= smallSide && index.data(CollectionModel::MovesRole).toBool())
        paintPlay(painter, picture);
    if (index.data(CollectionModel::FavouriteRole).toBool()) paintStar(painter, picture);

    const QFont font = nameFont(option.font);
    const bool selected = option.state & QStyle::State_Selected;
    const QRect name(option.rect.left() + 1, picture.bottom() + padding, option.rect.width() - 2,
                     QFontMetrics(font).height());
    painter->setFont(font);
    painter->setPen(option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
    painter->drawText(name, Qt::AlignCenter,
                      QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, name.width()));
}

} // namespace view
