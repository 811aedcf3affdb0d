// SPDX-License-Identifier: MIT
#pragma once

#include "io/text/expression.h"

#include <QDoubleSpinBox>
#include <QSpinBox>

#include <optional>

namespace view {

// An expression that was typed, and the value that it gave.
class TypedExpression {
public:
    // A text that does not stay as it was typed, such as a plain number, is forgotten.
    void keep(const QString& text, double value, io::NumberUnit unit);
    QString of(double value) const; // empty if it gave another value, or there is none

private:
    QString m_text;
    double m_value = 0;
};

// Spin boxes that take what number fields take: a comma as the decimal point, and expressions such as 1/2 or
// sqrt(3)/6, which are shown as long as the box has the value that they gave. What is unfinished changes
// nothing; what is no number when the box is left or at Enter, and what cannot become one, such as 1/0 or
// 1.234,5, brings back the value before, and a tool tip says why. The
// wheel does nothing without the focus, so that what the box stands in can be scrolled. Where the suffix is
// °, angles are taken as degrees: io::evaluate().
class NumberBox : public QDoubleSpinBox {
public:
    explicit NumberBox(QWidget* parent = nullptr);

    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;
    double valueFromText(const QString& text) const override; // rounded to the decimals of the box
    QString textFromValue(double value) const override;
    QString typedText() const { return m_typed.of(value()); } // empty for a plain number

protected:
    void wheelEvent(QWheelEvent* event) override;

private:
    TypedExpression m_typed;
    std::optional<double> m_before; // value before the text being typed
    mutable QString m_refusal;      // reason why that text is invalid
};

// Takes expressions whose value is whole. A number outside the range becomes the nearest in it. Groups of
// digits, where they are shown, are those of groupedNumber().
class WholeNumberBox : public QSpinBox {
public:
    explicit WholeNumberBox(QWidget* parent = nullptr);

    QString typedText() const { return m_typed.of(value()); } // empty for a plain number

protected:
    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;
    void wheelEvent(QWheelEvent* event) override;
    int valueFromText(const QString& text) const override;
    QString textFromValue(int value) const override;

private:
    TypedExpression m_typed;
    std::optional<int> m_before;
    mutable QString m_refusal;
};

} // namespace view
