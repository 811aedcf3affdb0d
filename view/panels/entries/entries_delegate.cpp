// SPDX-License-Identifier: MIT
#include "panels/entries/entries_delegate.h"

#include "document/problem.h"
#include "panels/entries/entries_model.h"
#include "widgets/icon.h"
#include "widgets/numbers/number_field.h"
#include "widgets/text/tooltip_text.h"
#include "widgets/thumbnail_tile.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QPersistentModelIndex>
#include <QToolTip>

namespace view {
namespace {

constexpr int padding = 5;
constexpr int gap = 9;
constexpr int badgeSide = 16;
constexpr auto editedIndex = "editedIndex";

struct Layout {
    QRect picture;
    QRect name;
    QRect subtitle;
    QRect badge;
};

QFont subtitleFont(const QFont& font) {
    QFont smaller = font;
    if (font.pointSizeF() > 0) smaller.setPointSizeF(font.pointSizeF() * 0.88);
    return smaller;
}

Layout layoutOf(const QStyleOptionViewItem& option) {
    const QRect row = option.rect;
    Layout layout;
    layout.picture = {row.left() + padding, row.top() + (row.height() - EntriesDelegate::pictureSide) / 2,
                      EntriesDelegate::pictureSide, EntriesDelegate::pictureSide};
    layout.badge = {row.right() - padding - badgeSide, row.top() + (row.height() - badgeSide) / 2, badgeSide,
                    badgeSide};
    const int left = layout.picture.right() + gap;
    const int width = layout.badge.left() - gap / 2 - left;
    const int nameHeight = QFontMetrics(option.font).height();
    const int subtitleHeight = QFontMetrics(subtitleFont(option.font)).height();
    const int top = row.top() + (row.height() - nameHeight - subtitleHeight) / 2;
    layout.name = {left, top, width, nameHeight};
    layout.subtitle = {left, top + nameHeight, width, subtitleHeight};
    if (option.direction == Qt::RightToLeft)
        for (QRect* part : {&layout.picture, &layout.name, &layout.subtitle, &layout.badge})
            *part = QStyle::visualRect(Qt::RightToLeft, row, *part);
    return layout;
}

QColor softened(QColor colour) {
    colour.setAlphaF(colour.alphaF() * 0.66F);
    return colour;
}

void paintBadge(QPainter& painter, const QStyleOptionViewItem& option, const QRect& area,
                const QVariant& severity) {
    if (!severity.isValid()) return;
    const bool error = severity.toInt() == static_cast<int>(document::Problem::Severity::Error);
    const bool selected = option.state & QStyle::State_Selected;
    icon(error ? QStringLiteral("error") : QStringLiteral("warning"))
        .paint(&painter, area, Qt::AlignCenter, selected ? QIcon::Selected : QIcon::Normal);
}

// Over both lines of a row: the name, and below it why it is refused.
class NameEditor : public QLineEdit {
public:
    using QLineEdit::QLineEdit;

    void setProblem(const QString& problem) {
        setAccessibleDescription(problem);
        setTextMargins(0, 0, 0, problem.isEmpty() ? 0 : QFontMetrics(subtitleFont(font())).height());
        update();
    }

protected:
    void paintEvent(QPaintEvent* event) override {
        QLineEdit::paintEvent(event);
        const QString problem = accessibleDescription();
        if (problem.isEmpty()) return;
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(problemColour(palette()), 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 2, 2);
        painter.setFont(subtitleFont(font()));
        const QRect line = rect().adjusted(6, 0, -5, -3);
        painter.drawText(line, Qt::AlignBottom | Qt::AlignLeft,
                         painter.fontMetrics().elidedText(problem, Qt::ElideRight, line.width()));
    }
};

} // namespace

EntriesDelegate::EntriesDelegate(NameCheck check, QObject* parent)
    : QStyledItemDelegate(parent), m_check(std::move(check)) {
    connect(this, &QAbstractItemDelegate::closeEditor, this, &EntriesDelegate::typingEnded);
}

void EntriesDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                            const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    option.showDecorationSelected = true; // whole row in every style
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, option.widget);

    const Layout layout = layoutOf(option);
    const Thumbnail thumbnail{
        static_cast<Thumbnail::State>(index.data(EntriesModel::ThumbnailStateRole).toInt()),
        index.data(Qt::DecorationRole).value<QPixmap>()};
    paintThumbnail(*painter, layout.picture, thumbnail, option.palette);

    const bool selected = option.state & QStyle::State_Selected;
    const QColor ink = option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
    const auto alignment = Qt::AlignVCenter | QStyle::visualAlignment(option.direction, Qt::AlignLeft);
    const QString mark = index.data(EntriesModel::ModifiedRole).toBool() ? QStringLiteral(" •") : QString();
    const QFontMetrics metrics(option.font);
    const QString name = metrics.elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideRight,
                                            layout.name.width() - metrics.horizontalAdvance(mark));
    painter->save();
    painter->setFont(option.font);
    painter->setPen(ink);
    painter->drawText(layout.name, static_cast<int>(alignment), name + mark);
    const QFont small = subtitleFont(option.font);
    painter->setFont(small);
    painter->setPen(softened(ink));
    painter->drawText(layout.subtitle, static_cast<int>(alignment),
                      QFontMetrics(small).elidedText(index.data(EntriesModel::SubtitleRole).toString(),
                                                     Qt::ElideRight, layout.subtitle.width()));
    paintBadge(*painter, option, layout.badge, index.data(EntriesModel::SeverityRole));
    painter->restore();
}

QSize EntriesDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    const int text = QFontMetrics(option.font).height() * 2;
    return {pictureSide + 120, qMax(pictureSide, text) + 2 * padding};
}

QWidget* EntriesDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                       const QModelIndex& index) const {
    auto* editor = new NameEditor(parent);
    editor->setAutoFillBackground(true);
    editor->setAccessibleName(tr("Name of the entry"));
    editor->setProperty(editedIndex, QVariant::fromValue(QPersistentModelIndex(index)));
    connect(editor, &QLineEdit::textEdited, this, [this, editor] {
        showProblem(*editor);
        if (!problem(*editor))
            emit nameTyped(editor->property(editedIndex).value<QPersistentModelIndex>(),
                           editor->text().trimmed());
    });
    return editor;
}

void EntriesDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    auto* line = qobject_cast<QLineEdit*>(editor);
    const QString name = index.data(Qt::EditRole).toString();
    // Keeps the typed text and the selection when a picture arrives meanwhile.
    if (line && !line->isModified() && line->text() != name) line->setText(name);
}

void EntriesDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                           const QModelIndex&) const {
    const Layout layout = layoutOf(option);
    const QRect lines = layout.name.united(layout.subtitle);
    editor->setGeometry(lines.adjusted(-4, -4, 0, 5).intersected(option.rect));
}

void EntriesDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                   const QModelIndex& index) const {
    emit typingEnded();
    QStyledItemDelegate::setModelData(editor, model, index);
}

bool EntriesDelegate::eventFilter(QObject* editor, QEvent* event) {
    auto* line = qobject_cast<QLineEdit*>(editor);
    if (line && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool finishes =
            key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab || key == Qt::Key_Backtab;
        if (finishes && problem(*line)) {
            showProblem(*line);
            return true;
        }
    }
    if (line && event->type() == QEvent::FocusOut && problem(*line)) {
        emit closeEditor(line, RevertModelCache);
        return false;
    }
    return QStyledItemDelegate::eventFilter(editor, event);
}

std::optional<QString> EntriesDelegate::problem(const QLineEdit& editor) const {
    const auto index = editor.property(editedIndex).value<QPersistentModelIndex>();
    return m_check(index, editor.text().trimmed());
}

void EntriesDelegate::showProblem(QLineEdit& editor) const {
    const QString reason = problem(editor).value_or(QString());
    static_cast<NameEditor&>(editor).setProblem(reason);
    if (reason.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(editor.mapToGlobal(QPoint(0, editor.height())), tooltipText(reason), &editor);
}

} // namespace view
