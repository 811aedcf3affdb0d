// SPDX-License-Identifier: MIT
#include "ifs/separation/determinant_sum.h"

#include "ifs/existence/exact_matrix.h"

namespace ifs {

template <int Dim> Dyadic excessOfDeterminants(std::span<const AffineMap<Dim>> maps) {
    Dyadic result(-1);
    for (const auto& map : maps) {
        const Dyadic det = determinant(exactMatrix<Dim>(map.linear));
        result = det.sign() < 0 ? result - det : result + det;
    }
    return result;
}

template <int Dim> bool fillSpace(std::span<const AffineMap<Dim>> maps) {
    return excessOfDeterminants<Dim>(maps).sign() >= 0;
}

template Dyadic excessOfDeterminants<2>(std::span<const AffineMap<2>>);
template Dyadic excessOfDeterminants<3>(std::span<const AffineMap<3>>);
template bool fillSpace<2>(std::span<const AffineMap<2>>);
template bool fillSpace<3>(std::span<const AffineMap<3>>);

} // namespace ifs
