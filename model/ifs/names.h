// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

// Names of the values of enumerations: the words that files, the command line and lists of the window know
// them by. They are never translated and never change, because files hold them.
namespace ifs {

template <class E> struct Named {
    E value;
    const char* id;
};

// The table of an enumeration, specialised beside it. Its order is that of lists.
template <class E> inline constexpr std::array<Named<E>, 0> names{};

template <class E> constexpr const char* nameOf(E value) {
    for (const Named<E>& each : names<E>)
        if (each.value == value) return each.id;
    return "";
}

template <class E> constexpr std::optional<E> named(std::string_view id) {
    for (const Named<E>& each : names<E>)
        if (each.id == id) return each.value;
    return std::nullopt;
}

} // namespace ifs
