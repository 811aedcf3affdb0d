// SPDX-License-Identifier: MIT
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace view {

// Spin boxes that take what number fields take: a comma as the decimal point, and expressions such as 1/2 or
// sqrt(3)/6, which their value replaces. What is unfinished changes nothing, and Enter takes it back.
class NumberBox : public QDoubleSpinBox {
public:
    explicit NumberBox(QWidget* parent = nullptr);

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override; // as many decimals as the box has
};

// Takes expressions whose value is whole.
class WholeNumberBox : public QSpinBox {
public:
    using QSpinBox::QSpinBox;

protected:
    QValidator::State validate(QString& text, int& position) const override;
    int valueFromText(const QString& text) const override;
};

} // namespace view
