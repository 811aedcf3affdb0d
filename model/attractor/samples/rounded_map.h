// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/arithmetic/arithmetic.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace attractor {

// Coefficients rounded to multiples of a unit, as the key of a hash table. −0 is 0.
struct RoundedMap {
    std::array<double, 6> values{};

    RoundedMap(const std::array<double, 6>& coefficients, double perUnit) : values(coefficients) {
        for (double& value : values)
            value = std::round(value * perUnit) + 0.0;
    }
    friend bool operator==(const RoundedMap&, const RoundedMap&) = default;
};

struct RoundedMapHash {
    std::size_t operator()(const RoundedMap& map) const {
        std::uint64_t hash = 0;
        for (const double value : map.values)
            hash = mixed(hash ^ std::bit_cast<std::uint64_t>(value));
        return static_cast<std::size_t>(hash);
    }
};

} // namespace attractor
