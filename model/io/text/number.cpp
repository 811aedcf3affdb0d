// SPDX-License-Identifier: MIT
#include "io/text/number.h"

namespace io {

std::optional<double> parseNumber(QStringView text) {
    const QByteArray digits = text.trimmed().toLatin1();
    return notation::parseNumber({digits.constData(), std::size_t(digits.size())});
}

QByteArray formatNumber(double value) {
    return QByteArray::fromStdString(notation::formatNumber(value));
}

} // namespace io
