// SPDX-License-Identifier: MIT
#include "panels/maps/maps_delegate.h"

#include "widgets/number_field.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QtMath>

#include <algorithm>

namespace view {

namespace {

constexpr int margin = 4; // left and right of a cell's text

struct NumberParts {
    QString whole;
    QString fraction; // with its point
};

NumberParts split(const QString& number) {
    const auto point = number.contains(u'e') ? -1 : number.indexOf(u'.');
    return {point < 0 ? number : number.left(point), point < 0 ? QString() : number.mid(point)};
}

int fractionWidth(const QFontMetrics& metrics, int decimals) {
    return decimals == 0 ? 0 : metrics.horizontalAdvance(u'.') + decimals * metrics.horizontalAdvance(u'0');
}

// With as many decimals as there is room for.
QString fitting(double value, const QFontMetrics& metrics, int width) {
    for (int decimals = maxDecimals; decimals > 0; --decimals)
        if (QString text = roundedNumber(value, decimals); metrics.horizontalAdvance(text) <= width)
            return text;
    const QString whole = roundedNumber(value, 0);
    return metrics.horizontalAdvance(whole) <= width ? whole : QString::number(value, 'g', 1);
}

QColor textColour(const QStyleOptionViewItem& option) {
    const auto group = option.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
    return option.palette.color(group, option.state & QStyle::State_Selected ? QPalette::HighlightedText
                                                                             : QPalette::Text);
}

void paintSwatch(QPainter& painter, const QRect& cell, const QColor& colour, const QColor& rim) {
    QRectF swatch(0, 0, 16, 12);
    swatch.moveCenter(QRectF(cell).center());
    painter.setRenderHint(QPainter::Antialiasing);
    QColor line = rim;
    line.setAlphaF(0.35F);
    painter.setPen(QPen(line, 1));
    painter.setBrush(colour);
    painter.drawRoundedRect(swatch, 2.5, 2.5);
}

} // namespace

void paintWarningSign(QPainter& painter, const QRectF& area, const QPalette& palette) {
    const bool dark = palette.color(QPalette::Base).lightness() < 128;
    const QPointF top(area.center().x(), area.top());
    QPainterPath sign;
    sign.moveTo(top);
    sign.lineTo(area.bottomRight());
    sign.lineTo(area.bottomLeft());
    sign.closeSubpath();
    const QColor amber = dark ? QColor(255, 184, 77) : QColor(214, 120, 0);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(amber, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(amber);
    painter.drawPath(sign);
    const qreal unit = area.height() / 10;
    painter.setPen(QPen(dark ? Qt::black : Qt::white, 1.4 * unit, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(top.x(), area.top() + 3.6 * unit), QPointF(top.x(), area.top() + 6 * unit));
    painter.drawPoint(QPointF(top.x(), area.top() + 8.4 * unit));
    painter.restore();
}

MapsDelegate::MapsDelegate(MapsModel* model, QObject* parent) : QStyledItemDelegate(parent), m_model(model) {}

QWidget* MapsDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                    const QModelIndex& index) const {
    auto* field = new NumberField(parent);
    field->setFrame(false);
    field->setAutoFillBackground(true);
    field->setAccessibleName(tr("%1 of map %2")
                                 .arg(m_model->headerData(index.column(), Qt::Horizontal).toString())
                                 .arg(index.row() + 1));
    connect(field, &NumberField::edited, m_model,
            [model = m_model, cell = QPersistentModelIndex(index)](double value) {
                model->preview(cell, value);
            });
    return field;
}

void MapsDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    auto* field = static_cast<NumberField*>(editor);
    if (!field->isEdited()) field->editValue(index.data(Qt::EditRole).toDouble(), m_model->typedText(index));
}

void MapsDelegate::setModelData(QWidget* editor, QAbstractItemModel*, const QModelIndex& index) const {
    const auto* field = static_cast<NumberField*>(editor);
    m_model->keepTyped(index, field->value(), field->typedText());
    m_model->commitEdit(); // the value is there already
}

void MapsDelegate::destroyEditor(QWidget* editor, const QModelIndex& index) const {
    const QString problem = static_cast<NumberField*>(editor)->problem();
    m_model->cancelEdit(); // nothing to cancel after a commit
    QStyledItemDelegate::destroyEditor(editor, index);
    if (!problem.isEmpty()) emit refused(tr("%1 The cell keeps its value.").arg(problem));
}

void MapsDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                        const QModelIndex&) const {
    // Wide enough for what is typed, even over a narrow column: over those that Tab comes to later.
    QRect area = option.rect;
    area.setWidth(std::max(area.width(), editor->sizeHint().width()));
    area.moveRight(std::min(area.right(), editor->parentWidget()->width() - 1));
    area.moveLeft(std::max(area.left(), 0));
    editor->setGeometry(area);
}

bool MapsDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                               const QModelIndex& index) {
    if (index.column() == MapsModel::Colour) {
        const bool space =
            event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space;
        if (space || event->type() == QEvent::MouseButtonDblClick) {
            emit colourRequested(index);
            return true;
        }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

void MapsDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                         const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    if (index.column() == MapsModel::Enabled) {
        QStyledItemDelegate::paint(painter, given, index);
        return;
    }
    const QString text = option.text;
    option.text.clear();
    option.icon = {};
    option.features &= ~QStyleOptionViewItem::HasDecoration;
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    painter->save();
    painter->setFont(option.font);
    painter->setPen(textColour(option));
    const QRect inside = option.rect.adjusted(margin, 0, -margin, 0);
    const bool warned = !index.data(MapsModel::WarningRole).toString().isEmpty();
    if (index.column() == MapsModel::Colour) {
        paintSwatch(*painter, option.rect, index.data(Qt::DecorationRole).value<QColor>(),
                    textColour(option));
    } else if (m_model->isNumber(index.column())) {
        if (const QString typed = m_model->typedText(index);
            !typed.isEmpty() && option.fontMetrics.horizontalAdvance(typed) <= inside.width() + margin) {
            painter->drawText(inside.adjusted(-margin, 0, 0, 0), Qt::AlignRight | Qt::AlignVCenter, typed);
            painter->restore();
            return;
        }
        const int decimals = index.data(MapsModel::DecimalsRole).toInt();
        const int fraction = fractionWidth(option.fontMetrics, decimals);
        const QRect whole = inside.adjusted(-margin, 0, -fraction, 0);
        const NumberParts parts = split(text);
        if (option.fontMetrics.horizontalAdvance(parts.whole) > whole.width()) { // in the middle of a drag
            painter->drawText(
                inside.adjusted(-margin, 0, 0, 0), Qt::AlignRight | Qt::AlignVCenter,
                fitting(index.data(Qt::EditRole).toDouble(), option.fontMetrics, inside.width() + margin));
            painter->restore();
            return;
        }
        painter->drawText(whole, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, parts.whole);
        painter->drawText(QRect(whole.right() + 1, inside.top(), fraction + margin, inside.height()),
                          Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, parts.fraction);
    } else {
        QRect rest = inside;
        if (warned) {
            QRectF sign(0, 0, 11, 10);
            sign.moveCenter(QPointF(inside.left() + 6, inside.center().y() + 0.5));
            paintWarningSign(*painter, sign, option.palette);
            rest.setLeft(rest.left() + 18);
        }
        painter->drawText(rest, Qt::AlignLeft | Qt::AlignVCenter,
                          option.fontMetrics.elidedText(text, Qt::ElideRight, rest.width()));
    }
    painter->restore();
}

QSize MapsDelegate::sizeHint(const QStyleOptionViewItem& given, const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const int height = option.fontMetrics.height() + 8;
    if (index.column() == MapsModel::Enabled || index.column() == MapsModel::Colour) return {26, height};
    const QString text = option.text;
    if (!m_model->isNumber(index.column())) {
        const bool warned = !index.data(MapsModel::WarningRole).toString().isEmpty();
        const int wide = qCeil(QFontMetricsF(option.font).horizontalAdvance(text)); // or it would be cut off
        return {wide + 2 * margin + (warned ? 18 : 0), height};
    }
    const int fraction = fractionWidth(option.fontMetrics, index.data(MapsModel::DecimalsRole).toInt());
    return {option.fontMetrics.horizontalAdvance(split(text).whole) + fraction + 2 * margin, height};
}

} // namespace view
