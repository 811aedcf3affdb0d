// SPDX-License-Identifier: MIT
#include "notation/text/typed_coefficient.h"

#include "notation/text/expression.h"
#include "notation/text/number.h"

#include <string>

namespace notation {

std::optional<ifs::TypedCoefficient> typedCoefficient(int which, std::string_view text) {
    if (parseNumber(text)) return std::nullopt;
    const auto number = evaluate(text);
    if (!number) return std::nullopt;
    return ifs::TypedCoefficient{which, *number, evaluateExactly(text).value_or(ifs::Surd::none()),
                                 std::string(text)};
}

} // namespace notation
