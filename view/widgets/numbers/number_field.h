// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/numbers/number_text.h"

#include <QLineEdit>

namespace view {

// The colour of a frame or mark that says something is wrong, readable on the palette's base.
QColor problemColour(const QPalette& palette);

// A number typed in the C locale. Shows a few digits at rest and all of them while it has the focus. Each
// keystroke, wheel step or arrow key that yields a number is reported; text that is no number gets a red
// frame and its reason, and is never taken. What is unfinished leaves the last number in force; what is
// finished and cannot be taken, such as 1/0 or 1.234,5, reports the number before the edit again. The wheel
// does nothing without the focus.
class NumberField : public QLineEdit {
    Q_OBJECT

public:
    explicit NumberField(QWidget* parent = nullptr);

    double value() const { return m_value; }
    // Sets the value of the model. While the user is typing, the text is left alone.
    void setValue(double value, const QString& typed = {}); // `typed`: text as typed, if known
    // Starts typing: all digits, or as it was written, selected.
    void editValue(double value, const QString& typed = {});
    QString typedText() const; // text as typed; empty for a plain number

    void setRange(const NumberRange& range);
    // Takes angles as degrees: 90, 90° and pi/2 are the same, and Enter shows the number.
    void setDegrees();
    // Magnitude up to which numbers read 0 until edited.
    void setRounding(double rounding) { m_rounding = rounding; }
    // Sets the step of arrow keys (Shift: ×10, Alt or Ctrl: ×0.1), of the wheel and of drags (Shift: ×0.1,
    // Ctrl: ×10).
    void setStep(double step) { m_step = step; }
    // Steps like the wheel, also without the focus: one edit until endSteps(), or none after cancelSteps().
    void takeSteps(int count, Qt::KeyboardModifiers modifiers);
    void endSteps();
    void cancelSteps() { abandon(); }
    QString problem() const; // reason why the present text is invalid; empty if it is a number
    bool isEdited() const { return m_edited; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void edited(double value);
    void committed(); // sent for Enter or loss of focus with a number, after an edit
    void cancelled(); // sent for Esc or loss of focus with another text, after an edit

protected:
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    void beginEdit();
    void takeText();
    void step(int count, double size);
    void finish();
    void abandon();
    void showValue();
    void showProblem(const QString& problem);
    bool leavesToDocument(const QKeyEvent& event);

    QString valueText() const;
    void keepTyped(const QString& text);

    double m_value = 0;
    double m_before = 0; // value before the edit
    double m_typedValue = 0;
    QString m_typed; // expression with the value m_typedValue
    double m_step = 0.01;
    double m_rounding = 0;
    NumberRange m_range;
    io::NumberUnit m_unit = io::NumberUnit::None;
    bool m_edited = false;
    int m_wheelRest = 0; // eighths of a degree not yet worth a step
};

} // namespace view
