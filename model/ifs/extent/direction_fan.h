// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ifs {

// Space cut into simplicial cones with unit directions as edges: first the orthants, then each cone halved
// `depth` times across its widest angle. A vector is a non-negative combination v = Σ p_k g_k of the edges of
// its cone, so values H_k ≥ h(g_k) of a support function (sublinear!) bound it everywhere: h(v) ≤ Σ p_k H_k.
// Only +, ×, ÷ and √ decide, so every machine cuts alike. docs/mathematics.md, "Support table".
template <int Dim> class DirectionFan {
public:
    explicit DirectionFan(int depth);
    // A fan in the plane of e_1, −e_1, e_2, −e_2 and these vectors, of any length but 0, without those that
    // coincide.
    explicit DirectionFan(const std::vector<Vector<Dim>>& directions);

    // Unit vectors; the first 2·Dim are e_1, −e_1, e_2, −e_2, …
    const std::vector<Vector<Dim>>& directions() const { return m_directions; }

    // v = Σ factor_k · directions()[index_k], with factors ≥ 0.
    struct Combination {
        std::array<std::uint32_t, Dim> index;
        Vector<Dim> factor;
    };
    Combination combination(const Vector<Dim>& v) const {
        if constexpr (Dim == 2)
            if (!m_around.empty()) return between(v);
        std::size_t cell = 1;
        Vector<Dim> p;
        for (int k = 0; k < Dim; ++k) {
            const bool negative = v[k] < 0;
            cell = 2 * cell + negative;
            p[k] = negative ? -v[k] : v[k];
        }
        // v = p_a g_a + p_b g_b + … = (p_a − p_b) g_a + p_b (g_a + g_b) + …, where g_a + g_b = length · (new
        // edge).
        while (cell < m_splits.size()) {
            const Split& split = m_splits[cell];
            double& a = p[split.a];
            double& b = p[split.b];
            const bool nearB = a < b;
            double& smaller = nearB ? a : b;
            (nearB ? b : a) -= smaller;
            smaller *= split.length;
            cell = 2 * cell + nearB;
        }
        return {m_cones[cell - m_splits.size()], p};
    }

    // The upper bound of h(v), given one value per direction.
    double bound(const Vector<Dim>& v, const std::vector<double>& values) const {
        const Combination parts = combination(v);
        double result = 0;
        for (int k = 0; k < Dim; ++k)
            result += parts.factor[k] * values[parts.index[std::size_t(k)]];
        return result;
    }

private:
    using Cone = std::array<std::uint32_t, Dim>; // indices of directions
    struct Split {
        int a, b;      // edges between which the cone is halved
        double length; // |g_a + g_b|
    };

    // Combination of the two neighbours among given directions.
    Combination between(const Vector<Dim>& v) const;
    void divide(std::size_t cell, const Cone& cone);
    Split widestAngle(const Cone& cone) const;
    std::uint32_t index(const Vector<Dim>& direction);

    // Cells are numbered as in a binary heap: cell c is cut into 2c (keeps g_a) and 2c + 1 (keeps g_b). The
    // orthants are cells 2^Dim … 2^(Dim+1) − 1.
    std::vector<Split> m_splits;
    std::vector<Cone> m_cones;
    std::vector<Vector<Dim>> m_directions;
    // Directions that were given, counter-clockwise; empty where cones are halved.
    std::vector<std::uint32_t> m_around;
};

} // namespace ifs
