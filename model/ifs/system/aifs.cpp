// SPDX-License-Identifier: MIT
#include "ifs/system/aifs.h"

namespace ifs {

template <int Dim> RowStochastic<Dim> rowStochastic(const Simplex<Dim>& simplex, const AffineMap<Dim>& map) {
    RowStochastic<Dim> matrix;
    for (std::size_t j = 0; j < simplex.size(); ++j)
        matrix.row(Eigen::Index(j)) = barycentric<Dim>(simplex, map(simplex[j])).transpose();
    return matrix;
}

template <int Dim>
std::vector<RowStochastic<Dim>> rowStochastic(const Simplex<Dim>& simplex,
                                              std::span<const AffineMap<Dim>> maps) {
    std::vector<RowStochastic<Dim>> matrices;
    matrices.reserve(maps.size());
    for (const auto& map : maps)
        matrices.push_back(rowStochastic<Dim>(simplex, map));
    return matrices;
}

template <int Dim> AffineMap<Dim> affineMap(const Simplex<Dim>& simplex, const RowStochastic<Dim>& matrix) {
    Simplex<Dim> images;
    for (std::size_t j = 0; j < images.size(); ++j)
        images[j] = point<Dim>(simplex, matrix.row(Eigen::Index(j)).transpose());
    return simplexMap<Dim>(simplex, images);
}

template <int Dim> bool isNonNegative(const RowStochastic<Dim>& matrix) {
    return matrix.minCoeff() >= -1e-12;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template RowStochastic<Dim> rowStochastic<Dim>(const Simplex<Dim>&, const AffineMap<Dim>&);              \
    template std::vector<RowStochastic<Dim>> rowStochastic<Dim>(const Simplex<Dim>&,                         \
                                                                std::span<const AffineMap<Dim>>);            \
    template AffineMap<Dim> affineMap<Dim>(const Simplex<Dim>&, const RowStochastic<Dim>&);                  \
    template bool isNonNegative<Dim>(const RowStochastic<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
