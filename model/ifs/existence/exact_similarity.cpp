// SPDX-License-Identifier: MIT
#include "ifs/existence/exact_similarity.h"

#include "ifs/existence/exact_matrix.h"

#include <cstddef>

namespace ifs {

template <int Dim> std::optional<std::vector<Dyadic>> squaredRatios(std::span<const AffineMap<Dim>> maps) {
    std::vector<Dyadic> result;
    for (const auto& map : maps) {
        const ExactMatrix<Dim> a = exactMatrix<Dim>(map.linear), square = transposed(a) * a;
        for (std::size_t i = 0; i < Dim; ++i)
            for (std::size_t j = 0; j < Dim; ++j)
                if (!(square[i][j] == (i == j ? square[0][0] : Dyadic()))) return std::nullopt;
        result.push_back(square[0][0]);
    }
    return result;
}

template std::optional<std::vector<Dyadic>> squaredRatios<2>(std::span<const AffineMap<2>>);
template std::optional<std::vector<Dyadic>> squaredRatios<3>(std::span<const AffineMap<3>>);

} // namespace ifs
