// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <optional>

// Numbers as panels show and take them: in every language with a decimal point.
namespace view {

// A few digits to read, not to edit: at most four decimals and about six significant digits.
QString shortNumber(double value);

// All digits: reads back as the same double.
QString fullNumber(double value);

// A whole number to read, with narrow spaces between groups of three digits from ten thousand on: a comma or
// a point there means something else in the next language.
QString groupedNumber(double value);

// Where a number may lie, ends included unless `open`.
struct NumberRange {
    std::optional<double> min;
    std::optional<double> max;
    enum class Ends { Closed, Open } ends = Ends::Closed;
};

// What `text` says when it is typed alone: as in files, but one comma may stand for the decimal point, which
// is where many keyboards have it. Files and pasted tables never read it so.
std::optional<double> typedNumber(const QString& text);

// Why `text` is not a number that can be taken, as a sentence for the user; empty when it is one.
QString numberProblem(const QString& text, const NumberRange& range = {});

// value + count·step, without the digits that binary addition leaves behind.
double stepped(double value, double step, int count);

} // namespace view
