// SPDX-License-Identifier: MIT
#include "entry/text/typed_coefficient.h"

#include "entry/text/expression.h"
#include "entry/text/number.h"

#include <string>

namespace entry {

std::optional<ifs::TypedCoefficient> typedCoefficient(int which, std::string_view text) {
    if (parseNumber(text)) return std::nullopt;
    const auto number = evaluate(text);
    if (!number) return std::nullopt;
    return ifs::TypedCoefficient{which, *number, evaluateExactly(text).value_or(ifs::Surd::none()),
                                 std::string(text)};
}

} // namespace entry
