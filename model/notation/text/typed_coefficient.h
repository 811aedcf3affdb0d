// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <optional>
#include <string_view>
#include <utility>

namespace notation {

// A coefficient as it is written, 1/3 or sqrt(3)/6, without white space at its ends; nullopt for a plain
// number and what evaluate() does not understand. Its number is that of evaluate().
std::optional<ifs::TypedCoefficient> typedCoefficient(int which, std::string_view text);

// Keeps the text with the map where its number is that coefficient.
template <int Dim> void keepTyped(ifs::WeightedMap<Dim>& map, int which, std::string_view text) {
    if (which < 0 || which >= Dim * (Dim + 1)) return;
    if (auto typed = typedCoefficient(which, text);
        typed && typed->number == ifs::coefficient<Dim>(map.map, which))
        map.typed.set(std::move(*typed));
}

} // namespace notation
