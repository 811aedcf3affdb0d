// SPDX-License-Identifier: MIT
#include "io/number.h"

#include <charconv>
#include <cmath>

namespace io {

std::optional<double> parseNumber(QStringView text) {
    const QByteArray digits = text.trimmed().toLatin1();
    const char* first = digits.constData();
    const char* last = first + digits.size();
    if (first != last && *first == '+') {
        ++first;
        if (first != last && *first == '-') return std::nullopt;
    }
    double value = 0;
    const auto result = std::from_chars(first, last, value, std::chars_format::general);
    if (result.ec != std::errc() || result.ptr != last || !std::isfinite(value)) return std::nullopt;
    return value;
}

QByteArray formatNumber(double value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value == 0 ? 0.0 : value);
    return QByteArray(buffer, result.ptr - buffer);
}

} // namespace io
