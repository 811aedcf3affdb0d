// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/numbers/surd.h"
#include "ifs/system/affine_map.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ifs {

// A coefficient as it was typed, such as 1/3 or √3/6, beside the double that the map holds.
struct TypedCoefficient {
    int which = 0;     // 0 … Dim² − 1 for the matrix row by row, then the vector: the letters a, b, …
    double number = 0; // valid only while the coefficient equals this double
    Surd value{};
    std::string text{};

    friend bool operator==(const TypedCoefficient& a, const TypedCoefficient& b) {
        return a.which == b.which && a.number == b.number && a.text == b.text;
    }
};

template <int Dim> double coefficient(const AffineMap<Dim>& map, int which) {
    return which < Dim * Dim ? map.linear(which / Dim, which % Dim) : map.translation[which - Dim * Dim];
}

// Typed coefficients of one map, shared by all copies of it, since an entry is copied at every step of a
// drag.
class TypedCoefficients {
public:
    TypedCoefficients() noexcept = default; // explicit noexcept, because GCC 12 does not always deduce it
    bool isEmpty() const { return !m_list; }
    void set(TypedCoefficient typed) {
        std::vector<TypedCoefficient> list = without(typed.which);
        list.insert(std::ranges::upper_bound(list, typed.which, {}, &TypedCoefficient::which),
                    std::move(typed));
        m_list = std::make_shared<const std::vector<TypedCoefficient>>(std::move(list));
    }
    void clear(int which) {
        if (m_list) keep(without(which));
    }
    // The typed coefficient, if it still belongs to this number; else null.
    const TypedCoefficient* of(int which, double number) const {
        if (!m_list) return nullptr;
        const auto found = std::ranges::find(*m_list, which, &TypedCoefficient::which);
        return found != m_list->end() && found->number == number ? &*found : nullptr;
    }
    template <int Dim> const TypedCoefficient* of(int which, const AffineMap<Dim>& map) const {
        return of(which, coefficient(map, which));
    }

    friend bool operator==(const TypedCoefficients& a, const TypedCoefficients& b) {
        return a.m_list == b.m_list || (a.m_list && b.m_list && *a.m_list == *b.m_list);
    }

private:
    std::vector<TypedCoefficient> without(int which) const {
        std::vector<TypedCoefficient> list = m_list ? *m_list : std::vector<TypedCoefficient>{};
        std::erase_if(list, [which](const TypedCoefficient& each) { return each.which == which; });
        return list;
    }
    void keep(std::vector<TypedCoefficient> list) {
        m_list.reset();
        if (!list.empty()) m_list = std::make_shared<const std::vector<TypedCoefficient>>(std::move(list));
    }

    std::shared_ptr<const std::vector<TypedCoefficient>> m_list; // sorted by `which`; null: none
};

} // namespace ifs
