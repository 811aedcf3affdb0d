// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/extent.h"
#include "ifs/separation/contact_graph.h"
#include "ifs/system/affine_map.h"
#include "ifs/system/branch.h"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ifs {

// Whether a proof takes coefficients as exact or as rounded values; see stored_rounding.h.
enum class Certainty { Exact, ToRounding };

class NeighbourGraph;

// nullopt where the maps are not similarities of one ratio, to rounding error, or no end of neighbours is
// found within bounded work. The box is that of the attractor.
template <int Dim>
std::optional<NeighbourGraph> neighbourGraph(std::span<const AffineMap<Dim>> maps,
                                             const BoundingBox<Dim>& box);

// The maps h = w_σ⁻¹w_τ between pieces of one size, of similarities with one ratio, as they arise from one
// another: A ∩ h(A) = ∪ w_i(A ∩ h'(A)) with h' = w_i⁻¹ h w_j. Finitely many of them have h(A) near A. Vertex
// 0 is the identity. docs/mathematics.md, "Neighbours".
class NeighbourGraph {
public:
    struct Edge {
        std::size_t from, i, j, to;
    };

    Certainty certainty() const { return m_certainty; }
    void setCertainty(Certainty certainty) { m_certainty = certainty; }
    std::size_t maps() const { return m_maps; }
    // All maps examined, including those that turned out to be of no neighbours, and the steps between them;
    // a map comes before those that are found from it.
    std::size_t found() const { return m_found; }
    std::span<const Edge> steps() const { return m_steps; }
    // Axes that span the affine hull of the attractor, where it is parallel to them; empty where it is the
    // plane or space.
    const std::vector<int>& axes() const { return m_axes; }
    double ratio() const { return m_ratio; }
    // Number of maps, the identity excepted, with h(A) ∩ A ≠ ∅.
    std::size_t neighbours() const { return m_count - 1; }
    // Two words of different first letters with the same map, where there are such.
    const std::optional<std::pair<Word, Word>>& overlap() const { return m_overlap; }
    // Returns true if the pieces of two maps have a common point.
    bool meet(std::size_t i, std::size_t j) const { return m_meet[i * m_maps + j] != 0; }
    // Returns true if i ≠ j and these pieces are proved to be disjoint for the coefficients themselves,
    // whatever the certainty of the graph.
    bool areApart(std::size_t i, std::size_t j) const {
        if (i > j) std::swap(i, j);
        return i != j && (m_certainty == Certainty::Exact ? !meet(i, j)
                                                          : !m_apart.empty() && m_apart[i * m_maps + j] != 0);
    }
    // The graph of the contacts of neighbours, without the identity. Requires that no words overlap.
    ContactGraph contacts() const;
    // Factor by which the number of different maps w_σ, |σ| = n, grows with n; the number of maps if no words
    // overlap (Ngai and Wang). nullopt if pieces have too many different relative positions.
    std::optional<ContactGraph::Radius> growth() const;

private:
    template <int Dim> friend class NeighbourSearch;
    template <int Dim>
    friend std::optional<NeighbourGraph> neighbourGraph(std::span<const AffineMap<Dim>>,
                                                        const BoundingBox<Dim>&);
    Certainty m_certainty = Certainty::Exact;
    double m_ratio = 0;
    std::size_t m_maps = 0, m_count = 0;
    std::vector<Edge> m_edges; // sorted by `from` and `i`
    std::size_t m_found = 0;
    std::vector<Edge> m_steps;
    std::vector<int> m_axes;
    std::vector<char> m_meet;
    std::vector<char> m_apart; // empty, or for i < j
    std::optional<std::pair<Word, Word>> m_overlap;
};

// Returns true if the maps, their inverses and products of a few of them are doubles without rounding.
bool areShort(std::span<const AffineMap<2>> maps);

} // namespace ifs
