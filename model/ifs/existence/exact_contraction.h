// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <functional>
#include <span>

namespace ifs {

// Returns true if all linear parts are triangular in one complex basis, known without rounding: so are those
// that commute, keep the flag of some axes, or keep a common direction in the plane. Their joint spectral
// radius is max ρ(A_i). False for more than 16 maps. docs/mathematics.md, "When does a system have an
// attractor?"
template <int Dim> bool areJointlyTriangular(std::span<const AffineMap<Dim>> maps);

// Whether the joint spectral radius of maps of the plane is proved to be below 1.
using ProvesContraction = std::function<bool(std::span<const AffineMap<2>> maps)>;

// Returns true if the joint spectral radius of the linear parts is proved to be below 1: without rounding, by
// the norms of support_norm.h, lyapunov_norm.h and common_matrix.h or by joint triangularity; or by what
// `contractsInPlane` proves of each strong component of the graph of coefficients that do not vanish. There
// may be no double below 1 that bounds it.
template <int Dim>
bool contractExactly(std::span<const AffineMap<Dim>> maps, const ProvesContraction& contractsInPlane);

} // namespace ifs
