// SPDX-License-Identifier: MIT
#include "io/text/typed_coefficient.h"

#include "io/text/expression.h"
#include "io/text/number.h"

#include <QString>

namespace io {

std::optional<ifs::TypedCoefficient> typedCoefficient(int which, QStringView text) {
    const QString simple = text.toString().simplified();
    if (parseNumber(simple)) return std::nullopt;
    const auto number = evaluate(simple);
    if (!number) return std::nullopt;
    return ifs::TypedCoefficient{which, *number, evaluateExactly(simple).value_or(ifs::Surd::none()),
                                 simple.toStdString()};
}

} // namespace io
