// SPDX-License-Identifier: MIT
#include "io/text/expression.h"

#include "io/text/number.h"

#include <QByteArray>

namespace io {

std::optional<double> evaluate(QStringView text) {
    return evaluate(text, NumberUnit::None);
}

std::optional<double> evaluate(QStringView text, NumberUnit unit) {
    if (const auto number = parseNumber(text)) return number;
    return notation::evaluate(text.toUtf8().toStdString(), unit);
}

std::optional<ifs::Surd> evaluateExactly(QStringView text) {
    return parseNumber(text) ? std::nullopt : notation::evaluateExactly(text.toUtf8().toStdString());
}

bool isAngle(QStringView text) {
    return notation::isAngle(text.toUtf8().toStdString());
}

bool isWithoutValue(QStringView text) {
    return notation::isWithoutValue(text.toUtf8().toStdString());
}

} // namespace io
