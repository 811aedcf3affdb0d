// SPDX-License-Identifier: MIT
#include "widgets/numbers/number_text.h"

#include "io/text/coefficient.h"
#include "io/text/number.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

QString refusal(const char* text) {
    return QCoreApplication::translate("NumberField", text);
}

QString withoutTrailingZeros(QString text) {
    if (!text.contains(u'.')) return text;
    while (text.endsWith(u'0'))
        text.chop(1);
    if (text.endsWith(u'.')) text.chop(1);
    return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

QString withPoint(const QString& text) {
    const bool comma =
        // Function arguments, as in min(1, 2).
        text.count(u',') == 1 && !text.contains(u'.') && !text.contains(u'(');
    return (comma ? QString(text).replace(u',', u'.') : text).trimmed();
}

// Returns true if a text that is not taken as a number would be too large a one.
bool isTooLarge(const QString& text) {
    const QByteArray digits = withPoint(text).toLatin1();
    double value = 0;
    const bool isSigned = digits.startsWith('+') && !digits.startsWith("+-");
    const char* end = digits.constData() + digits.size();
    const auto result = io::fromChars(digits.constData() + (isSigned ? 1 : 0), end, value);
    return result.ptr == end && !std::isnan(value) &&
           (result.ec == std::errc::result_out_of_range ||
            (result.ec == std::errc() && !io::isCoefficient(value)));
}

QString rangeProblem(double value, const NumberRange& range) {
    const bool open = range.ends == NumberRange::Ends::Open;
    if (range.min && (open ? value <= *range.min : value < *range.min))
        return (open ? refusal(QT_TRANSLATE_NOOP("NumberField", "The number must be greater than %1."))
                     : refusal(QT_TRANSLATE_NOOP("NumberField", "The number must be at least %1.")))
            .arg(fullNumber(*range.min));
    if (range.max && (open ? value >= *range.max : value > *range.max))
        return (open ? refusal(QT_TRANSLATE_NOOP("NumberField", "The number must be less than %1."))
                     : refusal(QT_TRANSLATE_NOOP("NumberField", "The number must be at most %1.")))
            .arg(fullNumber(*range.max));
    return {};
}

} // namespace

QString roundedNumber(double value, int decimals) {
    if (!std::isfinite(value)) return std::isnan(value) ? QStringLiteral("–") : QStringLiteral("∞");
    const double size = std::abs(value);
    if (size >= 1e6 || (size > 0 && size < 5e-5)) return QString::number(value, 'g', 3);
    const int order = size == 0 ? 0 : static_cast<int>(std::floor(std::log10(size)));
    const int most = std::clamp(5 - std::max(order, 0), 0, decimals);
    return withoutTrailingZeros(QString::number(value, 'f', std::max(most, 2 - order)));
}

QString shortNumber(double value) {
    return roundedNumber(value, maxDecimals);
}

QString fullNumber(double value) {
    return QString::fromLatin1(io::formatNumber(value));
}

QString groupedNumber(double value) {
    QString text = QString::number(value, 'f', 0);
    if (std::abs(value) < 9999.5) return text;
    for (qsizetype at = text.size() - 3; at > (value < 0 ? 1 : 0); at -= 3)
        text.insert(at, groupSeparator);
    return text;
}

std::optional<double> typedNumber(const QString& text, io::NumberUnit unit) {
    const auto number = io::evaluate(withPoint(text), unit);
    // Nullopt for numbers that no file may hold.
    return number && io::isCoefficient(*number) ? number : std::nullopt;
}

bool isExpression(const QString& text) {
    return !text.isEmpty() && !io::parseNumber(withPoint(text));
}

bool staysAsTyped(const QString& text, io::NumberUnit unit) {
    return isExpression(text) && (unit == io::NumberUnit::None || !io::isAngle(withPoint(text)));
}

bool isWithoutValue(const QString& text) {
    return io::isWithoutValue(withPoint(text));
}

bool isBeyondRepair(const QString& text) {
    static const QRegularExpression twoSigns(QStringLiteral("[.,][0-9]*[.,]"));
    const bool isList = text.contains(u'('); // function arguments, as in min(1,2,3)
    return isWithoutValue(text) || (!isList && twoSigns.match(text).hasMatch());
}

bool isFinishedNumber(const QString& text, io::NumberUnit unit) {
    return typedNumber(text, unit) || isTooLarge(text) || isBeyondRepair(text);
}

QString numberProblem(const QString& text, const NumberRange& range, io::NumberUnit unit) {
    if (const auto value = typedNumber(text, unit)) return rangeProblem(*value, range);
    const QString shown = text.trimmed();
    if (shown.isEmpty()) return refusal(QT_TRANSLATE_NOOP("NumberField", "A number is missing here."));
    if (isTooLarge(shown))
        return refusal(QT_TRANSLATE_NOOP("NumberField", "“%1” is too large a number.")).arg(shown);
    if (isWithoutValue(shown))
        return refusal(QT_TRANSLATE_NOOP("NumberField", "“%1” has no finite value.")).arg(shown);
    return refusal(QT_TRANSLATE_NOOP("NumberField", "“%1” is not a number.")).arg(shown);
}

double paceOfSteps(Qt::KeyboardModifiers modifiers) {
    double pace = 1;
    if (modifiers & Qt::ControlModifier) pace *= 10;
    if (modifiers & (Qt::ShiftModifier | Qt::AltModifier)) pace /= 10;
    return pace;
}

double stepped(double value, double step, int count) {
    const double sum = value + count * step;
    // Twelve digits, which hide the tail of 0.1 + 0.2.
    return io::parseNumber(QString::number(sum, 'g', 12)).value_or(sum);
}

} // namespace view
