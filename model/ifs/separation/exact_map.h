// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/dimension/moments.h"
#include "ifs/existence/dyadic.h"
#include "ifs/system/affine_map.h"
#include "ifs/system/branch.h"

#include <array>
#include <optional>
#include <span>

namespace ifs {

// An affine map without rounding.
template <int Dim> struct ExactMap {
    std::array<std::array<Dyadic, Dim>, Dim> linear;
    std::array<Dyadic, Dim> translation;

    friend bool operator==(const ExactMap&, const ExactMap&) = default;
};

// numerator/denominator; the denominator is 0 where no single point is meant.
template <int Dim> struct ExactPoint {
    std::array<Dyadic, Dim> numerator;
    Dyadic denominator;
};

template <int Dim> ExactMap<Dim> exactWord(std::span<const AffineMap<Dim>> maps, const Word& word);
template <int Dim> ExactPoint<Dim> exactFixedPoint(const ExactMap<Dim>& map);
template <int Dim> ExactPoint<Dim> image(const ExactMap<Dim>& map, const ExactPoint<Dim>& point);
template <int Dim> bool isSame(const ExactPoint<Dim>& a, const ExactPoint<Dim>& b);

// Returns true if all maps have one fixed point in common; it is the attractor if they contract.
template <int Dim> bool haveCommonFixedPoint(std::span<const AffineMap<Dim>> maps);

// That point, rounded, with a bound of the distance to it; nullopt if there is none, or no double is near it.
template <int Dim> std::optional<Mean<Dim>> commonFixedPoint(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
