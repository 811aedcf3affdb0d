// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/dyadic.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <vector>

namespace ifs {

// The s_i² of maps with A_iᵀA_i = s_i²I, without rounding; nullopt where one is no similarity.
template <int Dim> std::optional<std::vector<Dyadic>> squaredRatios(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
