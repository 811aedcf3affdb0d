// SPDX-License-Identifier: MIT
#include "ifs/existence/exact_contraction.h"

#include "ifs/existence/common_matrix.h"
#include "ifs/existence/exact_matrix.h"
#include "ifs/existence/expansion.h"
#include "ifs/existence/lyapunov_norm.h"
#include "ifs/existence/support_norm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ifs {

namespace {

template <int Dim> Dyadic traceOfProduct(const ExactMatrix<Dim>& a, const ExactMatrix<Dim>& b) {
    Dyadic result;
    for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j)
            result = result + a[i][j] * b[j][i];
    return result;
}

// Independent matrices, in echelon form.
template <int Dim> class Span {
public:
    // Extends the span by the matrix; false if it is already in the span.
    bool extend(const ExactMatrix<Dim>& matrix) {
        Row row;
        for (std::size_t k = 0; k < row.size(); ++k)
            row[k] = matrix[k / Dim][k % Dim];
        for (const auto& [known, pivot] : m_rows) {
            if (row[pivot].sign() == 0) continue;
            const Dyadic factor = row[pivot];
            for (std::size_t k = 0; k < row.size(); ++k)
                row[k] = row[k] * known[pivot] - known[k] * factor;
        }
        const auto entry = std::ranges::find_if(row, [](const Dyadic& number) { return number.sign() != 0; });
        if (entry == row.end()) return false;
        const auto pivot = std::size_t(entry - row.begin());
        m_rows.push_back({std::move(row), pivot});
        return true;
    }

private:
    using Row = std::array<Dyadic, std::size_t(Dim* Dim)>;
    struct Echelon {
        Row row;
        std::size_t pivot;
    };
    std::vector<Echelon> m_rows;
};

// The commutators that do not vanish. False when one of them is not nilpotent.
template <int Dim>
bool haveNilpotentCommutators(const std::vector<ExactMatrix<Dim>>& maps,
                              std::vector<ExactMatrix<Dim>>& commutators) {
    const ExactMatrix<Dim> zero;
    for (std::size_t i = 0; i < maps.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto commutator = difference(maps[i] * maps[j], Dyadic(1), maps[j] * maps[i]);
            if (commutator == zero) continue;
            if (determinant(commutator).sign() != 0) return false;
            if (traceOfProduct<Dim>(commutator, commutator).sign() != 0) return false;
            commutators.push_back(commutator);
        }
    return true;
}

// The strong components of the graph of coefficients that do not vanish in some map, each a set of axes.
template <int Dim> std::vector<std::vector<int>> componentsOf(std::span<const AffineMap<Dim>> maps) {
    std::array<std::array<bool, Dim>, Dim> reached{};
    for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j)
            reached[i][j] = i == j || std::ranges::any_of(maps, [&](const AffineMap<Dim>& map) {
                                return map.linear(Eigen::Index(i), Eigen::Index(j)) != 0;
                            });
    for (std::size_t via = 0; via < Dim; ++via)
        for (std::size_t i = 0; i < Dim; ++i)
            for (std::size_t j = 0; j < Dim; ++j)
                reached[i][j] = reached[i][j] || (reached[i][via] && reached[via][j]);
    std::vector<std::vector<int>> result;
    for (std::size_t i = 0; i < Dim; ++i) {
        const auto together = std::ranges::find_if(result, [&](const std::vector<int>& axes) {
            const auto first = std::size_t(axes.front());
            return reached[i][first] && reached[first][i];
        });
        if (together == result.end())
            result.push_back({int(i)});
        else
            together->push_back(int(i));
    }
    return result;
}

template <int Dim>
bool contractAlong(std::span<const AffineMap<Dim>> maps, const std::vector<int>& axes,
                   const ProvesContraction& contractsInPlane) {
    if (axes.size() == 1)
        return std::ranges::all_of(maps, [axis = axes[0]](const AffineMap<Dim>& map) {
            return std::abs(map.linear(axis, axis)) < 1;
        });
    if (axes.size() == Dim) return false;
    std::vector<AffineMap<2>> blocks;
    for (const auto& map : maps) {
        AffineMap<2> block;
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
                block.linear(i, j) = map.linear(axes[std::size_t(i)], axes[std::size_t(j)]);
        blocks.push_back(block);
    }
    return contractsInPlane(blocks);
}

} // namespace

// Triangular together if and only if all commutators lie in the radical of the algebra that the matrices
// generate (McCoy), that is, where the traces of their products with all of it vanish. Words span the
// algebra, each that adds to the span extending others that did.
template <int Dim> bool areJointlyTriangular(std::span<const AffineMap<Dim>> maps) {
    constexpr std::size_t maxMaps = 16;
    if (maps.size() > maxMaps) return false;
    std::vector<ExactMatrix<Dim>> exact, commutators;
    for (const auto& map : maps)
        exact.push_back(exactMatrix<Dim>(map.linear));
    if (!haveNilpotentCommutators<Dim>(exact, commutators)) return false;
    Span<Dim> span;
    std::vector<ExactMatrix<Dim>> words{exactMatrix<Dim>(Matrix<Dim>::Identity())};
    span.extend(words.front());
    for (std::size_t k = 0; k < words.size(); ++k)
        for (const auto& map : exact) {
            ExactMatrix<Dim> longer = words[k] * map;
            if (!span.extend(longer)) continue;
            for (const auto& commutator : commutators)
                if (traceOfProduct<Dim>(longer, commutator).sign() != 0) return false;
            words.push_back(std::move(longer));
        }
    return true;
}

template <int Dim>
bool contractExactly(std::span<const AffineMap<Dim>> maps, const ProvesContraction& contractsInPlane) {
    if (exactEuclideanNorm<Dim>(maps) || supportNorm<Dim>(maps)) return true;
    if (areJointlyTriangular<Dim>(maps))
        return std::ranges::all_of(maps, [](const AffineMap<Dim>& map) {
            return exactExpansion<Dim>(exactMatrix<Dim>(map.linear)) == Expansion::No;
        });
    if (commonMatrixNorm<Dim>(maps) || lyapunovNorm<Dim>(maps)) return true;
    const auto components = componentsOf<Dim>(maps);
    return components.size() > 1 && std::ranges::all_of(components, [&](const std::vector<int>& axes) {
               return contractAlong<Dim>(maps, axes, contractsInPlane);
           });
}

template bool areJointlyTriangular<2>(std::span<const AffineMap<2>>);
template bool areJointlyTriangular<3>(std::span<const AffineMap<3>>);
template bool contractExactly<2>(std::span<const AffineMap<2>>, const ProvesContraction&);
template bool contractExactly<3>(std::span<const AffineMap<3>>, const ProvesContraction&);

} // namespace ifs
