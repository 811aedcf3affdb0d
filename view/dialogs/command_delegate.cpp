// SPDX-License-Identifier: MIT
#include "dialogs/command_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QStyle>

#include <algorithm>

namespace view {

namespace {

constexpr int gap = 24; // pixels; least distance between name and keys
constexpr int margin = 6;

} // namespace

void CommandDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                            const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    const QString name = index.data(NameRole).toString(), keys = index.data(KeysRole).toString();
    if (name.isEmpty()) return style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    const QRect text = style->subElementRect(QStyle::SE_ItemViewItemText, &option, option.widget);
    const int right = option.rect.right() - margin;
    const int keysWidth = keys.isEmpty() ? 0 : option.fontMetrics.horizontalAdvance(keys) + gap;
    option.text = option.fontMetrics.elidedText(name, Qt::ElideLeft,
                                                std::max(0, right - text.left() - margin - keysWidth));
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    const bool isSelected = option.state & QStyle::State_Selected;
    const auto group = option.state & QStyle::State_Enabled ? QPalette::Active : QPalette::Disabled;
    painter->save();
    painter->setFont(option.font);
    painter->setPen(
        option.palette.color(group, isSelected ? QPalette::HighlightedText : QPalette::PlaceholderText));
    painter->drawText(
        QRect(option.rect.left(), option.rect.top(), right - option.rect.left(), option.rect.height()),
        Qt::AlignRight | Qt::AlignVCenter, keys);
    painter->restore();
}

// Rows are as wide as the list, whatever the text.
QSize CommandDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    return {0, QStyledItemDelegate::sizeHint(option, index).height()};
}

} // namespace view
