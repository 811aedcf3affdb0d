// SPDX-License-Identifier: MIT
#include "panels/maps/maps_delegate.h"

#include "document/maps/map_names.h"
#include "panels/maps/layer_signs.h"
#include "panels/maps/map_thumbnails.h"
#include "widgets/numbers/number_field.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QtMath>

#include <algorithm>

namespace view {

namespace {

constexpr int margin = 4; // pixels left and right of the text of a cell

struct NumberParts {
    QString whole;
    QString fraction; // decimals including the point
};

NumberParts split(const QString& number) {
    const auto point = number.contains(u'e') ? -1 : number.indexOf(u'.');
    return {point < 0 ? number : number.left(point), point < 0 ? QString() : number.mid(point)};
}

int fractionWidth(const QFontMetrics& metrics, int decimals) {
    return decimals == 0 ? 0 : metrics.horizontalAdvance(u'.') + decimals * metrics.horizontalAdvance(u'0');
}

// A number with as many decimals as there is room for.
QString fitting(double value, const QFontMetrics& metrics, int width) {
    for (int decimals = maxDecimals; decimals > 0; --decimals)
        if (QString text = roundedNumber(value, decimals); metrics.horizontalAdvance(text) <= width)
            return text;
    return roundedNumber(value, 0);
}

// Paints a number in the middle of a drag, when columns keep their widths: the figures become narrower before
// any is left out.
void paintNarrowed(QPainter& painter, const QRect& area, const QString& text) {
    const int wide = painter.fontMetrics().horizontalAdvance(text);
    painter.translate(area.right() + 1, 0);
    painter.scale(std::min(1.0, double(area.width()) / std::max(1, wide)), 1);
    painter.drawText(QRect(-wide, area.top(), wide, area.height()),
                     Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, text);
}

QColor textColour(const QStyleOptionViewItem& option) {
    const auto group = option.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
    return option.palette.color(group, option.state & QStyle::State_Selected ? QPalette::HighlightedText
                                                                             : QPalette::Text);
}

bool isMark(int column) {
    return column == MapsModel::Enabled || column == MapsModel::Lock;
}

// Returns true if a row of a matrix in space begins, or the shift, or the weight behind it.
bool beginsGroup(const MapsModel& model, int column) {
    constexpr int letters = 12, inRow = 3;
    if (model.dimension() != 3) return false;
    for (const int first : {int(MapsModel::A), model.columnOf(MapsModel::EffectiveA)})
        if (column > first && column < first + letters && (column - first) % inRow == 0) return true;
    return column == model.columnOf(MapsModel::Weight);
}

QColor faded(QColor colour, float opacity) {
    colour.setAlphaF(opacity);
    return colour;
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

QWidget* MapsDelegate::createNameEditor(QWidget* parent, const QModelIndex& index) const {
    auto* field = new QLineEdit(parent);
    field->setFrame(false);
    field->setAutoFillBackground(true);
    field->setMaxLength(int(document::maxMapName));
    field->setAccessibleName(tr("Name of map %1").arg(index.row() + 1));
    connect(field, &QLineEdit::textEdited, m_model,
            [model = m_model, cell = QPersistentModelIndex(index)](const QString& name) {
                model->previewName(cell, name);
            });
    return field;
}

QWidget* MapsDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                    const QModelIndex& index) const {
    if (index.column() == MapsModel::Name) return createNameEditor(parent, index);
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
    if (auto* name = qobject_cast<QLineEdit*>(editor); name && index.column() == MapsModel::Name) {
        if (!name->isModified()) name->setText(index.data(Qt::EditRole).toString());
        return;
    }
    auto* field = static_cast<NumberField*>(editor);
    if (!field->isEdited()) field->editValue(index.data(Qt::EditRole).toDouble(), m_model->typedText(index));
}

void MapsDelegate::setModelData(QWidget* editor, QAbstractItemModel*, const QModelIndex& index) const {
    if (index.column() == MapsModel::Name) return m_model->commitEdit(); // set while typing
    const auto* field = static_cast<NumberField*>(editor);
    if (!field->problem().isEmpty()) return; // the cell keeps its value; closing the editor reports it
    m_model->keepTyped(index, field->value(), field->typedText());
    m_model->commitEdit(); // set while typing
    if (const QString remark = m_model->remark(index); !remark.isEmpty()) emit refused(remark);
}

void MapsDelegate::destroyEditor(QWidget* editor, const QModelIndex& index) const {
    const auto* field = qobject_cast<NumberField*>(editor);
    const QString problem = field ? field->problem() : QString();
    m_model->cancelEdit(); // no effect after a commit
    QStyledItemDelegate::destroyEditor(editor, index);
    if (!problem.isEmpty()) emit refused(tr("%1 The cell keeps its value.").arg(problem));
}

void MapsDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                        const QModelIndex&) const {
    // Wide enough for the typed text, at the cost of columns that Tab reaches later.
    QRect area = option.rect;
    area.setWidth(std::max(area.width(), editor->sizeHint().width()));
    area.moveRight(std::min(area.right(), editor->parentWidget()->width() - 1));
    area.moveLeft(std::max(area.left(), 0));
    editor->setGeometry(area);
}

bool MapsDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                               const QModelIndex& index) {
    const bool isSpace =
        event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space;
    if (index.column() == MapsModel::Colour && (isSpace || event->type() == QEvent::MouseButtonDblClick)) {
        emit colourRequested(index);
        return true;
    }
    if (!isMark(index.column())) return QStyledItemDelegate::editorEvent(event, model, option, index);
    const bool isMouse =
        event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::MouseButtonDblClick;
    const auto* mouse = isMouse ? static_cast<QMouseEvent*>(event) : nullptr;
    if (mouse && mouse->button() != Qt::LeftButton) return false;
    if (event->type() == QEvent::MouseButtonDblClick) return true; // the release toggles
    if (!mouse && !isSpace) return false;
    if (mouse && index.column() == MapsModel::Enabled && mouse->modifiers().testFlag(Qt::AltModifier)) {
        emit soloRequested(index);
        return true;
    }
    const bool isOn = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    return model->setData(index, isOn ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

void MapsDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                         const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QString text = option.text;
    option.text.clear();
    option.icon = {};
    option.features &= ~(QStyleOptionViewItem::HasDecoration | QStyleOptionViewItem::HasCheckIndicator);
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    painter->save();
    painter->setFont(option.font);
    painter->setPen(textColour(option));
    if (isMark(index.column()))
        paintMark(*painter, option, index);
    else if (index.column() == MapsModel::Colour)
        paintPicture(*painter, option, index);
    else if (m_model->isNumber(index.column()))
        paintNumber(*painter, option, index, text);
    else
        paintText(*painter, option, index, text);
    painter->restore();
}

// Faint where the eye is closed or the map is not locked, and beside a map that is shown alone.
void MapsDelegate::paintMark(QPainter& painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
    const bool isOn = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    const QColor colour = textColour(option);
    if (index.column() == MapsModel::Lock)
        return paintPadlock(painter, option.rect, isOn ? colour : faded(colour, 0.3F),
                            isOn ? Padlock::Closed : Padlock::Open);
    const ifs::MapId solo = m_model->solo();
    const bool isSolo = solo != ifs::MapId::None && solo == m_model->idAt(index.row());
    if (isSolo) { // ring around its eye
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(faded(colour, 0.15F));
        painter.setPen(QPen(colour, 1));
        QRectF ring(0, 0, 20, 15);
        ring.moveCenter(QRectF(option.rect).center());
        painter.drawRoundedRect(ring, 7, 7);
    }
    const bool isHidden = !isOn || (solo != ifs::MapId::None && !isSolo);
    paintEye(painter, option.rect, isHidden ? faded(colour, 0.45F) : colour, isOn ? Eye::Open : Eye::Closed);
}

// The colour as a bar, and beside it what the map makes of the attractor.
void MapsDelegate::paintPicture(QPainter& painter, const QStyleOptionViewItem& option,
                                const QModelIndex& index) const {
    const QRectF cell = QRectF(option.rect).adjusted(3, 2, -3, -2);
    const auto colour = index.data(Qt::DecorationRole).value<QColor>();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(faded(textColour(option), 0.35F), 1));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(cell.left() + 0.5, cell.top() + 0.5, 5, cell.height() - 1), 1.5, 1.5);
    const QRectF tile(cell.left() + 7, cell.top(), cell.width() - 7, cell.height());
    painter.setPen(Qt::NoPen);
    painter.setBrush(option.palette.color(QPalette::Base));
    painter.drawRoundedRect(tile, 2, 2);
    if (!m_thumbnails) return;
    const qreal ratio = painter.device()->devicePixelRatioF();
    m_thumbnails->setLook(tile.size().toSize(), ratio, faded(option.palette.color(QPalette::Text), 0.3F));
    const QImage picture = m_thumbnails->picture(index.row(), m_model->idAt(index.row()));
    if (!picture.isNull()) painter.drawImage(tile.topLeft(), picture);
}

void MapsDelegate::paintNumber(QPainter& painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index, const QString& text) const {
    const QRect inside = option.rect.adjusted(numberMargin, 0, -numberMargin, 0);
    if (beginsGroup(*m_model, index.column()))
        painter.fillRect(QRect(option.rect.topLeft(), QSize(1, option.rect.height())),
                         faded(textColour(option), 0.25F));
    if (const QString typed = m_model->typedText(index);
        !typed.isEmpty() && option.fontMetrics.horizontalAdvance(typed) <= inside.width()) {
        painter.drawText(inside, Qt::AlignRight | Qt::AlignVCenter, typed);
        return;
    }
    const int decimals = index.data(MapsModel::DecimalsRole).toInt();
    const int fraction = fractionWidth(option.fontMetrics, decimals);
    const QRect whole = inside.adjusted(0, 0, -fraction, 0);
    const NumberParts parts = split(text);
    if (option.fontMetrics.horizontalAdvance(parts.whole) > whole.width() ||
        option.fontMetrics.horizontalAdvance(parts.fraction) > fraction)
        return paintNarrowed(painter, inside,
                             m_model->isMoving() ? text // whose decimals stay
                                                 : fitting(index.data(Qt::EditRole).toDouble(),
                                                           option.fontMetrics, inside.width()));
    painter.drawText(whole, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, parts.whole);
    painter.drawText(QRect(whole.right() + 1, inside.top(), fraction + numberMargin, inside.height()),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, parts.fraction);
}

void MapsDelegate::paintText(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                             const QString& text) const {
    QRect rest = option.rect.adjusted(margin, 0, -margin, 0);
    if (index.column() != MapsModel::Name && !index.data(MapsModel::WarningRole).toString().isEmpty()) {
        QRectF sign(0, 0, 11, 10);
        sign.moveCenter(QPointF(rest.left() + 6, rest.center().y() + 0.5));
        paintWarningSign(painter, sign, option.palette);
        rest.setLeft(rest.left() + 18);
    }
    painter.drawText(rest, Qt::AlignLeft | Qt::AlignVCenter,
                     option.fontMetrics.elidedText(text, Qt::ElideRight, rest.width()));
}

QSize MapsDelegate::sizeHint(const QStyleOptionViewItem& given, const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const int height = option.fontMetrics.height() + 8;
    if (index.column() < MapsModel::Name) return {26, height};
    const QString text = option.text;
    if (!m_model->isNumber(index.column())) {
        const bool warned =
            index.column() != MapsModel::Name && !index.data(MapsModel::WarningRole).toString().isEmpty();
        // Otherwise the text would be cut off.
        const int wide = qCeil(QFontMetricsF(option.font).horizontalAdvance(text));
        return {wide + 2 * margin + (warned ? 18 : 0), height};
    }
    const int fraction = fractionWidth(option.fontMetrics, index.data(MapsModel::DecimalsRole).toInt());
    return {option.fontMetrics.horizontalAdvance(split(text).whole) + fraction + 2 * numberMargin, height};
}

} // namespace view
