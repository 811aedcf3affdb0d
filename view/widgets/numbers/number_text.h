// SPDX-License-Identifier: MIT
#pragma once

#include "io/text/expression.h"

#include <QString>

#include <optional>

// Numbers as panels show and take them: in every language with a decimal point.
namespace view {

constexpr int maxDecimals = 4;
// A few digits to read, not to edit: so many decimals, or three digits if that is more; six or so in all.
QString roundedNumber(double value, int decimals);
QString shortNumber(double value); // with the most decimals

// All digits: reads back as the same double.
QString fullNumber(double value);

// A whole number to read, with narrow spaces between groups of three digits from ten thousand on: a comma or
// a point there means something else in the next language.
QString groupedNumber(double value);
constexpr QChar groupSeparator(0x202f); // no line ends there

// Where a number may lie, ends included unless `open`.
struct NumberRange {
    std::optional<double> min;
    std::optional<double> max;
    enum class Ends { Closed, Open } ends = Ends::Closed;
};

// What `text` says when it is typed alone: a number as in files or an expression, see io::evaluate(); one
// comma may stand for the decimal point, which is where many keyboards have it. Files never read it so.
std::optional<double> typedNumber(const QString& text, io::NumberUnit unit = io::NumberUnit::None);
// Whether it says more than a plain number does.
bool isExpression(const QString& text);
// Whether it stays visible as it was typed: an expression, but no angle where degrees are expected, because
// pi/2 becomes 90 there.
bool staysAsTyped(const QString& text, io::NumberUnit unit);

// Whether it is a whole expression without a finite value, such as 1/0.
bool isWithoutValue(const QString& text);
// Whether nothing that is typed behind it makes a number of it: 1/0, or two decimal signs as in 1.234,5.
bool isBeyondRepair(const QString& text);
// Whether nothing needs to be typed any more: a number, also one outside every range, or one beyond repair.
bool isFinishedNumber(const QString& text, io::NumberUnit unit = io::NumberUnit::None);

// Why `text` is not a number that can be taken, as a sentence for the user; empty when it is one.
QString numberProblem(const QString& text, const NumberRange& range = {},
                      io::NumberUnit unit = io::NumberUnit::None);

// How far a step of the wheel or of a drag goes: a tenth with Shift or Alt, ten times with Ctrl.
double paceOfSteps(Qt::KeyboardModifiers modifiers);

// value + count·step, without the digits that binary addition leaves behind.
double stepped(double value, double step, int count);

} // namespace view
