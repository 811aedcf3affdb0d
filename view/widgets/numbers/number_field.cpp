// SPDX-License-Identifier: MIT
#include "widgets/numbers/number_field.h"

#include "io/text/number.h"
#include "widgets/text/tooltip_text.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QStatusTipEvent>
#include <QToolTip>
#include <QValidator>
#include <QWheelEvent>

#include <cmath>
#include <cstdlib>
#include <utility>

namespace view {

namespace {

// Number of steps of an arrow key.
double paceOf(Qt::KeyboardModifiers modifiers) {
    double pace = 1;
    if (modifiers & Qt::ShiftModifier) pace *= 10;
    if (modifiers & (Qt::AltModifier | Qt::ControlModifier)) pace /= 10;
    return pace;
}

// Lets anything be typed, and accepts numbers only: item views then refuse to commit the rest.
class NumberValidator : public QValidator {
public:
    NumberValidator(NumberRange range, io::NumberUnit unit, QObject* parent)
        : QValidator(parent), m_range(range), m_unit(unit) {}
    State validate(QString& text, int&) const override {
        return numberProblem(text, m_range, m_unit).isEmpty() ? Acceptable : Intermediate;
    }

private:
    NumberRange m_range;
    io::NumberUnit m_unit;
};

} // namespace

QColor problemColour(const QPalette& palette) {
    return palette.color(QPalette::Base).lightness() < 128 ? QColor(255, 107, 107) : QColor(200, 40, 40);
}

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
    setAlignment(Qt::AlignRight);
    setValidator(new NumberValidator(m_range, m_unit, this));
    setWhatsThis(
        tr("A number, with a decimal point or comma, or an expression such as 1/2, sqrt(3)/6, cos(36°) "
           "or pi. The arrow keys and the wheel change it: ten times as fast with Shift, a tenth as "
           "fast with Alt. Esc restores the previous number."));
    setInputMethodHints(Qt::ImhPreferNumbers);
    connect(this, &QLineEdit::textEdited, this, &NumberField::takeText);
    showValue();
}

void NumberField::setRange(const NumberRange& range) {
    m_range = range;
    delete validator();
    setValidator(new NumberValidator(range, m_unit, this));
}

void NumberField::setDegrees() {
    m_unit = io::NumberUnit::Degrees;
    setRange(m_range);
    setWhatsThis(
        tr("An angle in degrees, with or without °, or an expression such as 360/7. An expression with pi, "
           "or with asin, acos, atan or atan2, is in radians and becomes degrees: pi/2 is 90. The arrow keys "
           "and the wheel change it: ten times as fast with Shift, a tenth as fast with Alt. Esc restores "
           "the previous number."));
}

QString NumberField::problem() const {
    return m_edited ? numberProblem(text(), m_range, m_unit) : QString();
}

void NumberField::setValue(double value, const QString& typed) {
    if (m_edited) return;
    m_value = value;
    if (!typed.isEmpty()) keepTyped(typed);
    showValue();
}

void NumberField::editValue(double value, const QString& typed) {
    m_edited = false;
    m_value = value;
    keepTyped(typed);
    setText(valueText());
    selectAll();
}

void NumberField::keepTyped(const QString& text) {
    m_typed = staysAsTyped(text, m_unit) ? text.trimmed() : QString();
    m_typedValue = m_value;
}

QString NumberField::typedText() const {
    return m_typedValue == m_value ? m_typed : QString();
}

QString NumberField::valueText() const {
    return typedText().isEmpty() ? fullNumber(m_value) : m_typed;
}

void NumberField::showValue() {
    const double known = std::abs(m_value) <= m_rounding ? 0 : m_value;
    const QString shown = hasFocus() || !typedText().isEmpty() ? valueText() : shortNumber(known);
    if (text() != shown) setText(shown);
    showProblem({});
}

void NumberField::beginEdit() {
    if (!std::exchange(m_edited, true)) m_before = m_value;
}

void NumberField::takeText() {
    beginEdit();
    const QString reason = problem();
    showProblem(reason);
    if (!reason.isEmpty()) {
        if (!isFinishedNumber(text(), m_unit) || m_value == m_before) return;
        m_value = m_before; // restores the value before typing
        emit edited(m_value);
        return;
    }
    m_value = typedNumber(text(), m_unit).value_or(m_value);
    keepTyped(text());
    emit edited(m_value);
}

void NumberField::takeSteps(int count, Qt::KeyboardModifiers modifiers) {
    step(count, m_step * paceOfSteps(modifiers));
}

void NumberField::endSteps() {
    finish();
    showValue();
}

void NumberField::step(int count, double size) {
    const double next = stepped(m_value, size, count);
    if (isReadOnly() || !numberProblem(fullNumber(next), m_range).isEmpty()) return;
    beginEdit();
    m_value = next;
    setText(fullNumber(next));
    showProblem({});
    emit edited(next);
}

void NumberField::finish() {
    if (!m_edited) return;
    if (const QString reason = problem(); !reason.isEmpty()) {
        // In the status bar of the window, where it stays when the field has lost the focus.
        const QString name = accessibleName().isEmpty() ? text() : accessibleName();
        QStatusTipEvent kept(tr("%1: the number stays as it was. %2").arg(name, reason));
        QCoreApplication::sendEvent(this, &kept);
        abandon();
        return;
    }
    m_edited = false;
    // Replaces the typed text, which is a step of the document now.
    setText(isExpression(text()) ? valueText() : text());
    emit committed();
}

void NumberField::abandon() {
    if (!m_edited) return;
    m_edited = false;
    m_value = m_before;
    emit cancelled(); // tells the owner to restore it, too
    showValue();
}

void NumberField::showProblem(const QString& reason) {
    const bool shown = !reason.isEmpty();
    setAccessibleDescription(reason);
    if (shown && isVisible())
        QToolTip::showText(mapToGlobal(QPoint(0, height())), tooltipText(reason), this);
    else if (!shown && QToolTip::isVisible() && hasFocus())
        QToolTip::hideText();
    update();
}

void NumberField::focusInEvent(QFocusEvent* event) {
    QLineEdit::focusInEvent(event);
    if (!m_edited) {
        showValue();
        if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason) {
            end(false); // shows the first digits if there are too many
            home(true);
        }
    }
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() == Qt::PopupFocusReason) // context menu
        return;
    finish();
    showValue();
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
        step(event->key() == Qt::Key_Up ? 1 : -1, m_step * paceOf(event->modifiers()));
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!problem().isEmpty()) {
            showProblem(problem());
            return;
        }
        finish();
        selectAll();
        QLineEdit::keyPressEvent(event);
        return;
    case Qt::Key_Escape:
        if (m_edited) {
            abandon();
            selectAll();
            return;
        }
        break;
    default:
        break;
    }
    QLineEdit::keyPressEvent(event);
}

void NumberField::wheelEvent(QWheelEvent* event) {
    if (!hasFocus()) {
        event->ignore();
        return;
    }
    // Alt turns the wheel sideways on some platforms.
    const QPoint delta = event->angleDelta();
    m_wheelRest += std::abs(delta.y()) >= std::abs(delta.x()) ? delta.y() : delta.x();
    const int count = m_wheelRest / QWheelEvent::DefaultDeltasPerStep;
    m_wheelRest -= count * QWheelEvent::DefaultDeltasPerStep;
    if (count != 0) takeSteps(count, event->modifiers());
    event->accept();
}

// Undo and redo are those of the document, but while something is being typed.
bool NumberField::leavesToDocument(const QKeyEvent& event) {
    const bool undo = event.matches(QKeySequence::Undo);
    if (!undo && !event.matches(QKeySequence::Redo)) return false;
    if (m_edited && (undo ? isUndoAvailable() : isRedoAvailable())) return false;
    finish(); // after steps of the arrow keys, or typing without a change
    return true;
}

bool NumberField::event(QEvent* event) {
    // Takes Esc before any dialog or shortcut, to discard the typed text.
    if (event->type() == QEvent::ShortcutOverride && m_edited &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && leavesToDocument(static_cast<QKeyEvent&>(*event))) {
        event->ignore();
        return true;
    }
    if (event->type() == QEvent::ToolTip && !problem().isEmpty()) {
        showProblem(problem());
        return true;
    }
    return QLineEdit::event(event);
}

void NumberField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (problem().isEmpty()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(problemColour(palette()), 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 2, 2);
}

QSize NumberField::sizeHint() const {
    const int width = fontMetrics().horizontalAdvance(QStringLiteral("-0000.0000"));
    return {width + 12, QLineEdit::sizeHint().height()};
}

QSize NumberField::minimumSizeHint() const {
    const int width = fontMetrics().horizontalAdvance(QStringLiteral("-00.00"));
    return {width + 10, QLineEdit::minimumSizeHint().height()};
}

} // namespace view
