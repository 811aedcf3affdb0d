// SPDX-License-Identifier: MIT
#include "widgets/numbers/number_box.h"

#include "widgets/numbers/number_text.h"
#include "widgets/text/tooltip_text.h"

#include <QLineEdit>
#include <QRegularExpression>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace view {

namespace {

template <class Box> QString withoutUnits(const Box& box, QString text) {
    if (const QString prefix = box.prefix(); !prefix.isEmpty() && text.startsWith(prefix))
        text.remove(0, prefix.size());
    if (const QString suffix = box.suffix(); !suffix.isEmpty() && text.endsWith(suffix))
        text.chop(suffix.size());
    return text.remove(groupSeparator).trimmed();
}

template <class Box> io::NumberUnit unitOf(const Box& box) {
    return box.suffix().trimmed() == u"°" ? io::NumberUnit::Degrees : io::NumberUnit::None;
}

std::optional<double> rounded(const std::optional<double>& value, int decimals) {
    if (!value) return {};
    return QString::number(*value, 'f', decimals).toDouble();
}

std::optional<int> whole(const std::optional<double>& value, int min, int max) {
    if (!value || *value < min || *value > max || std::round(*value) != *value) return {};
    return static_cast<int>(*value);
}

// Returns false for 1.000 or 1,000, which may be groups of digits.
bool hasDecimals(const QString& typed) {
    const qsizetype point = std::max(typed.lastIndexOf(u'.'), typed.lastIndexOf(u','));
    return point >= 0 && typed.size() - point != 4 && !isExpression(typed);
}

// Returns true for 1.234.567, which some languages write so.
bool isInGroups(const QString& typed) {
    static const QRegularExpression groups(QStringLiteral("^[-+]?[0-9]{1,3}([.,])[0-9]{3}(\\1[0-9]{3})*$"));
    return groups.match(typed).hasMatch();
}

// Gives the box its value again, while it goes on showing the typed text.
template <class Box, class Value> void bringBack(Box& box, QLineEdit& edit, Value value) {
    const QString text = edit.text();
    const int position = edit.cursorPosition();
    box.setValue(value);
    edit.setText(text);
    edit.setCursorPosition(position);
}

template <class Box> QString refusalOf(const Box& box, const QString& text) {
    return numberProblem(withoutUnits(box, text), {double(box.minimum()), double(box.maximum())},
                         unitOf(box));
}

void sayOnce(QWidget& box, QString& refusal) {
    if (const QString reason = std::exchange(refusal, {}); !reason.isEmpty() && box.isVisible())
        QToolTip::showText(box.mapToGlobal(QPoint(0, box.height())), tooltipText(reason), &box);
}

} // namespace

void TypedExpression::keep(const QString& text, double value, io::NumberUnit unit) {
    m_text = staysAsTyped(text, unit) && typedNumber(text, unit)
                 ? text
                 : QString(); // a box may show a word for a value
    m_value = value;
}

QString TypedExpression::of(double value) const {
    return value == m_value ? m_text : QString();
}

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setLocale(QLocale::c());
    connect(lineEdit(), &QLineEdit::textEdited, this, [this](QString text) {
        if (!m_before) m_before = value();
        int position = 0;
        if (validate(text, position) == QValidator::Acceptable)
            m_typed.keep(withoutUnits(*this, text), valueFromText(text), unitOf(*this));
        else if (isBeyondRepair(withoutUnits(*this, text)) && value() != *m_before)
            bringBack(*this, *lineEdit(), *m_before);
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
        m_before.reset();
        sayOnce(*this, m_refusal);
    });
}

void NumberBox::wheelEvent(QWheelEvent* event) {
    hasFocus() ? QDoubleSpinBox::wheelEvent(event) : event->ignore();
}

QValidator::State NumberBox::validate(QString& text, int& position) const {
    QString plain = text;
    if (!text.contains(u'(')) plain.replace(u',', u'.'); // not in min(1, 2)
    int at = position;
    if (QDoubleSpinBox::validate(plain, at) == QValidator::Acceptable) {
        text = plain;
        position = at;
        return QValidator::Acceptable;
    }
    const auto value = rounded(typedNumber(withoutUnits(*this, text), unitOf(*this)), decimals());
    return value && *value >= minimum() && *value <= maximum() ? QValidator::Acceptable
                                                               : QValidator::Intermediate;
}

// Restores the value from before the first key if the typed text is no number at the end.
void NumberBox::fixup(QString& text) const {
    if (!m_before) return;
    m_refusal = refusalOf(*this, text);
    text = prefix() + textFromValue(*m_before) + suffix();
}

double NumberBox::valueFromText(const QString& text) const {
    const auto value = rounded(typedNumber(withoutUnits(*this, text), unitOf(*this)), decimals());
    return value ? *value : QDoubleSpinBox::valueFromText(text); // special text for the least value
}

QString NumberBox::textFromValue(double value) const {
    const QString typed = m_typed.of(value);
    return typed.isEmpty() ? QDoubleSpinBox::textFromValue(value) : typed;
}

WholeNumberBox::WholeNumberBox(QWidget* parent) : QSpinBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    connect(lineEdit(), &QLineEdit::textEdited, this, [this](QString text) {
        if (!m_before) m_before = value();
        int position = 0;
        if (validate(text, position) == QValidator::Acceptable)
            m_typed.keep(withoutUnits(*this, text), valueFromText(text), unitOf(*this));
        else if (isBeyondRepair(withoutUnits(*this, text)) && value() != *m_before)
            bringBack(*this, *lineEdit(), *m_before);
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
        m_before.reset();
        sayOnce(*this, m_refusal);
    });
}

QValidator::State WholeNumberBox::validate(QString& text, int& position) const {
    QString plain = text;
    const bool isGrouped = text.contains(groupSeparator); // stays grouped until the value is shown again
    plain.remove(groupSeparator);
    int at = position - int(text.left(position).count(groupSeparator));
    const QValidator::State state = QSpinBox::validate(plain, at);
    const QString typed = withoutUnits(*this, text);
    // Prevents the next digit from joining the previous ones.
    if (hasDecimals(typed) || (isBeyondRepair(typed) && !isInGroups(typed))) return QValidator::Intermediate;
    if (state == QValidator::Acceptable || !isExpression(typed)) {
        if (!isGrouped) {
            text = plain;
            position = at;
        }
        bool isNumber = false; // false outside the range
        typed.toLongLong(&isNumber);
        return state == QValidator::Invalid && isNumber ? QValidator::Intermediate : state;
    }
    return whole(typedNumber(typed, unitOf(*this)), minimum(), maximum()) ? QValidator::Acceptable
                                                                          : QValidator::Intermediate;
}

// The nearest number that the box can have, where a plain number was typed; else the value from before the
// first key.
void WholeNumberBox::fixup(QString& text) const {
    const QString typed = withoutUnits(*this, text);
    const auto number = isExpression(typed) ? std::nullopt : typedNumber(typed);
    if (number) {
        text = QString::number(int(std::clamp<double>(std::round(*number), minimum(), maximum())));
    } else if (m_before) {
        m_refusal = refusalOf(*this, text);
        text = prefix() + textFromValue(*m_before) + suffix();
    }
}

void WholeNumberBox::wheelEvent(QWheelEvent* event) {
    hasFocus() ? QSpinBox::wheelEvent(event) : event->ignore();
}

int WholeNumberBox::valueFromText(const QString& text) const {
    const QString typed = withoutUnits(*this, text);
    const auto value =
        isExpression(typed) ? whole(typedNumber(typed, unitOf(*this)), minimum(), maximum()) : std::nullopt;
    return value ? *value : QSpinBox::valueFromText(QString(text).remove(groupSeparator));
}

QString WholeNumberBox::textFromValue(int value) const {
    const QString typed = m_typed.of(value);
    if (!typed.isEmpty()) return typed;
    return isGroupSeparatorShown() ? groupedNumber(value) : QSpinBox::textFromValue(value);
}

} // namespace view
