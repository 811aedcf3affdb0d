// SPDX-License-Identifier: MIT
#include "panels/maps/calculated_maps.h"

#include "ifs/cage/control_cage.h"
#include "ifs/system/iterated_function_system.h"

#include <algorithm>

namespace view {

namespace {

constexpr double residue = 0x1p-48; // of the numbers that were added

template <class Numbers> double largest(const Numbers& numbers) {
    return numbers.cwiseAbs().maxCoeff();
}

template <class Numbers> void clean(Numbers& numbers, double size) {
    numbers = (numbers.array().abs() <= residue * size).select(0, numbers);
}

} // namespace

template <int Dim> std::optional<ifs::AffineMap<Dim>> displayOf(const document::Shape<Dim>& shape) {
    if (!shape.cage || shape.cage->rest == shape.cage->current) return ifs::AffineMap<Dim>{};
    if (ifs::bends(*shape.cage)) return std::nullopt;
    const ifs::AffineMap<Dim> display = ifs::displayMap(*shape.cage);
    return ifs::conjugate(display, ifs::IteratedFunctionSystem<Dim>{}) ? std::optional(display)
                                                                       : std::nullopt;
}
template std::optional<ifs::AffineMap<2>> displayOf(const document::Shape<2>& shape);
template std::optional<ifs::AffineMap<3>> displayOf(const document::Shape<3>& shape);

template <int Dim>
std::optional<ifs::AffineMap<Dim>> effectiveMap(const ifs::AffineMap<Dim>& display,
                                                const ifs::AffineMap<Dim>& map) {
    if (display == ifs::AffineMap<Dim>{}) return map;
    const auto effective = ifs::conjugate(display, map);
    if (!effective) return std::nullopt;
    return withoutResidue<Dim>(*effective, largest(display.translation) +
                                               largest(display.linear) * largest(map.translation));
}
template std::optional<ifs::AffineMap<2>> effectiveMap(const ifs::AffineMap<2>&, const ifs::AffineMap<2>&);
template std::optional<ifs::AffineMap<3>> effectiveMap(const ifs::AffineMap<3>&, const ifs::AffineMap<3>&);

template <int Dim> ifs::AffineMap<Dim> withoutResidue(const ifs::AffineMap<Dim>& map, double reach) {
    ifs::AffineMap<Dim> cleaned = map;
    clean(cleaned.linear, largest(map.linear));
    clean(cleaned.translation, std::max({reach, largest(map.translation), largest(map.linear)}));
    return cleaned;
}
template ifs::AffineMap<2> withoutResidue(const ifs::AffineMap<2>& map, double reach);
template ifs::AffineMap<3> withoutResidue(const ifs::AffineMap<3>& map, double reach);

} // namespace view
