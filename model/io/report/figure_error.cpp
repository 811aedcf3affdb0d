// SPDX-License-Identifier: MIT
#include "io/report/figure_error.h"

#include <algorithm>

namespace io {

QString errorNote(const std::vector<double>& values, double error, double size, int digits) {
    const double share = 0.5 * std::pow(10, -digits);
    const bool shows = std::ranges::any_of(
        values, [&](double value) { return std::abs(value) > error && error > share * std::abs(value); });
    const bool isAllNoise = error > share * size && std::ranges::all_of(values, [&](double value) {
                                return std::abs(value) <= error;
                            });
    if (!shows && !isAllNoise) return {};
    // Two digits, never less than the error.
    QString text = QString::number(error, 'g', 2);
    if (text.toDouble() < error) text = QString::number(error * 1.06, 'g', 2);
    return QStringLiteral(" ± %1").arg(text);
}

} // namespace io
