// SPDX-License-Identifier: MIT
#include "io/report/figure_error.h"

#include <algorithm>

namespace io {

namespace {

// The power of ten of the first digit.
int leadingPower(double value) {
    return int(std::floor(std::log10(std::abs(value))));
}

// Number of digits from a value down to sizes of that order.
int digitsAbove(double value, double size) {
    if (value == 0 || !(size > 0) || !std::isfinite(value)) return 0;
    return std::max(0, int(std::floor(std::log10(std::abs(value) / size))));
}

} // namespace

QString figure(double value, double error, double size, int digits) {
    constexpr int allDigits = 17;
    int shown = std::min(digits + digitsAbove(value, size), allDigits);
    if (value != 0 && error > 0 && std::isfinite(value))
        shown = std::clamp(leadingPower(value) - leadingPower(error) + 2, 1, shown);
    return QString::number(value == 0 ? 0.0 : value, 'g', shown);
}

QString boundText(double bound) {
    QString text = QString::number(bound, 'g', 2);
    if (text.toDouble() < bound) text = QString::number(bound * 1.06, 'g', 2);
    return text;
}

QString errorNote(const std::vector<double>& values, double error, double size, int digits) {
    const double share = 0.5 * std::pow(10, -digits);
    const bool shows = std::ranges::any_of(values, [&](double value) {
        const double lastDigit = share * std::pow(10, -digitsAbove(value, size));
        return std::abs(value) > error && error > lastDigit * std::abs(value);
    });
    const bool isAllNoise = error > share * size && std::ranges::all_of(values, [&](double value) {
                                return std::abs(value) <= error;
                            });
    return shows || isAllNoise ? QStringLiteral(" ± %1").arg(boundText(error)) : QString();
}

} // namespace io
