// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <vector>

namespace ifs {

// An answer to h_A(u) = max over x in A of ⟨u,x⟩ for an attractor A.
template <int Dim> struct SupportValue {
    double value = 0;         // value attained on the attractor, up to rounding: value ≤ h_A(u)
    double error = 0;         // h_A(u) ≤ value + error, certified, rounding included
    Vector<Dim> point;        // point of the attractor with ⟨u, point⟩ = value
    std::vector<int> address; // known beginning of its address, outermost first
};

} // namespace ifs
