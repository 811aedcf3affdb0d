// SPDX-License-Identifier: MIT
#pragma once

#include "notation/text/expression.h"

#include <QStringView>

#include <optional>

// Those of entry/text/expression.h, of Qt's texts.
namespace io {

using notation::maxExpression;
using notation::NumberUnit;

std::optional<double> evaluate(QStringView text);
std::optional<double> evaluate(QStringView text, NumberUnit unit);
std::optional<ifs::Surd> evaluateExactly(QStringView text);
bool isAngle(QStringView text);
bool isWithoutValue(QStringView text);

} // namespace io
