// SPDX-License-Identifier: MIT
#pragma once

#include "io/text/expression.h"

#include <QString>

#include <optional>

// Numbers as panels show and take them: in every language with a decimal point.
namespace view {

constexpr int maxDecimals = 4;
// A few digits to read, not to edit: `decimals` decimals, or three digits if that is more; six or so in all.
QString roundedNumber(double value, int decimals);
QString shortNumber(double value); // shortest text with the most decimals allowed

// The number with all digits: reads back as the same double.
QString fullNumber(double value);

// A whole number to read, with narrow spaces between groups of three digits from ten thousand on: a comma or
// a point there means something else in the next language.
QString groupedNumber(double value);
constexpr QChar groupSeparator(0x202f); // no-break space

// Permitted range of a number, ends included unless `open`.
struct NumberRange {
    std::optional<double> min;
    std::optional<double> max;
    enum class Ends { Closed, Open } ends = Ends::Closed;
};

// The value of `text` when it is typed alone: a number as in files or an expression, see io::evaluate(); one
// comma may stand for the decimal point, which is where many keyboards have it. Files never read it so.
std::optional<double> typedNumber(const QString& text, io::NumberUnit unit = io::NumberUnit::None);
// Returns true if the text is more than a plain number.
bool isExpression(const QString& text);
// Returns true if the text stays visible as it was typed: an expression, but no angle where degrees are
// expected, because pi/2 becomes 90 there.
bool staysAsTyped(const QString& text, io::NumberUnit unit);

// Returns true for a complete expression without a finite value, such as 1/0.
bool isWithoutValue(const QString& text);
// Returns true if no text typed behind it makes it a number: 1/0, or two decimal signs as in 1.234,5.
bool isBeyondRepair(const QString& text);
// Returns true if no more input is needed: a number, also one outside every range, or one beyond repair.
bool isFinishedNumber(const QString& text, io::NumberUnit unit = io::NumberUnit::None);

// Why `text` is not a number that can be taken, as a sentence for the user; empty when it is one.
QString numberProblem(const QString& text, const NumberRange& range = {},
                      io::NumberUnit unit = io::NumberUnit::None);

// Factor of a step of the wheel or of a drag: a tenth with Shift or Alt, ten times with Ctrl.
double paceOfSteps(Qt::KeyboardModifiers modifiers);

// value + count·step, without the digits that binary addition leaves behind.
double stepped(double value, double step, int count);

} // namespace view
