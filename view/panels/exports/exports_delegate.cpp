// SPDX-License-Identifier: MIT
#include "panels/exports/exports_delegate.h"

#include "panels/exports/exports_model.h"
#include "widgets/icon.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QPainter>

#include <algorithm>

namespace view {

namespace {

constexpr int padding = 6;
constexpr int barHeight = 4;
constexpr int barGap = 4;
constexpr int badgeSide = 16;

using State = QueuedExport::State;

int wrappedHeight(const QFontMetrics& metrics, const QString& text, int width) {
    constexpr int maxLines = 8; // lines; the rest is in the tool tip
    const QRect room(0, 0, std::max(1, width), maxLines * metrics.lineSpacing());
    return std::min(room.height(), metrics.boundingRect(room, Qt::TextWordWrap, text).height());
}

QFont smaller(QFont font) {
    if (font.pointSizeF() > 0) font.setPointSizeF(font.pointSizeF() * 0.88);
    return font;
}

void paintBar(QPainter& painter, const QRect& area, double progress, const QPalette& palette,
              const QColor& ink) {
    QColor empty = ink;
    empty.setAlphaF(0.2F);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(empty);
    painter.drawRoundedRect(area, barHeight / 2.0, barHeight / 2.0);
    QRectF done(area);
    done.setWidth(area.width() * progress);
    const bool isOnHighlight = ink == palette.color(QPalette::HighlightedText);
    painter.setBrush(isOnHighlight ? ink : palette.color(QPalette::Highlight));
    if (done.width() >= 1) painter.drawRoundedRect(done, barHeight / 2.0, barHeight / 2.0);
}

} // namespace

QSize ExportsDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
    const bool isWrapped = view && State(index.data(ExportsModel::StateRole).toInt()) == State::Failed;
    const QFontMetrics small(smaller(option.font));
    const int width = view ? view->viewport()->width() - 3 * padding - badgeSide - 2 : 0;
    const int second = isWrapped
                           ? wrappedHeight(small, index.data(ExportsModel::SentenceRole).toString(), width)
                           : small.height();
    const int lines = QFontMetrics(option.font).height() + second;
    return {8 * option.fontMetrics.averageCharWidth(), lines + barGap + barHeight + 2 * padding};
}

void ExportsDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
    QStyleOptionViewItem row = option;
    initStyleOption(&row, index);
    row.text.clear();
    const QWidget* widget = option.widget;
    const QStyle* style = widget ? widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &row, painter, widget);

    const auto state = State(index.data(ExportsModel::StateRole).toInt());
    const bool isSelected = row.state & QStyle::State_Selected;
    const QColor ink = row.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text);
    QRect area = row.rect.adjusted(padding, padding, -padding, -padding);
    if (state == State::Failed) {
        const QRect badge(area.right() - badgeSide, area.center().y() - badgeSide / 2, badgeSide, badgeSide);
        icon(QStringLiteral("warning"))
            .paint(painter, badge, Qt::AlignCenter, isSelected ? QIcon::Selected : QIcon::Normal);
        area.setRight(badge.left() - padding);
    }
    painter->save();
    painter->setPen(ink);
    painter->setFont(row.font);
    const QFontMetrics metrics(row.font);
    painter->drawText(
        QRect(area.x(), area.y(), area.width(), metrics.height()), Qt::AlignVCenter,
        metrics.elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideMiddle, area.width()));
    const QFont small = smaller(row.font);
    const QFontMetrics smallMetrics(small);
    QColor soft = ink;
    soft.setAlphaF(0.75F);
    painter->setPen(soft);
    painter->setFont(small);
    const int second = area.y() + metrics.height();
    const QString sentence = index.data(ExportsModel::SentenceRole).toString();
    if (state == State::Failed)
        painter->drawText(QRect(area.x(), second, area.width(), area.bottom() + 1 - second), Qt::TextWordWrap,
                          sentence);
    else
        painter->drawText(QRect(area.x(), second, area.width(), smallMetrics.height()), Qt::AlignVCenter,
                          smallMetrics.elidedText(sentence, Qt::ElideRight, area.width()));
    if (const QVariant progress = index.data(ExportsModel::ProgressRole); progress.isValid())
        paintBar(*painter, {area.x(), second + smallMetrics.height() + barGap, area.width(), barHeight},
                 progress.toDouble(), row.palette, ink);
    painter->restore();
}

} // namespace view
