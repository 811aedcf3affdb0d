// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"
#include "ifs/system/symmetry.h"
#include "ifs/system/typed_coefficients.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ifs {

// Names one map of one system for as long as the map lives, whatever its index in the list. 0 is no map.
enum class MapId : std::uint32_t { None = 0 };

template <int Dim> struct WeightedMap {
    MapId id = MapId::None;
    AffineMap<Dim> map;
    // The weight as given: not normalised, possibly 0 or negative; nullopt when the source gives none.
    std::optional<double> weight;
    bool enabled = true;
    TypedCoefficients typed{}; // typed texts of `map`

    friend bool operator==(const WeightedMap&, const WeightedMap&) = default;
};

// A factor of the weight of `to` where the chaos game has just applied `from`.
struct Link {
    MapId from = MapId::None;
    MapId to = MapId::None;
    double weight = 1;

    friend bool operator==(const Link&, const Link&) = default;
};

// Returns true if the weight excludes the map.
template <int Dim> bool isOff(const WeightedMap<Dim>& map);

// w_1 … w_N with their weights, in the order in which addresses number them, and the group Γ under which the
// attractor is symmetric: it is the attractor of {γ∘w_i : γ ∈ Γ}. Links hold for all copies of a map.
template <int Dim> struct IteratedFunctionSystem {
    std::vector<WeightedMap<Dim>> maps;
    Symmetry<Dim> symmetry{};  // must be valid
    std::vector<Link> links{}; // links other than 1; see ifs/system/links.h

    friend bool operator==(const IteratedFunctionSystem&, const IteratedFunctionSystem&) = default;
};

// Ids that no map of the system has and no link names, in increasing order.
template <int Dim> MapId freshId(const IteratedFunctionSystem<Dim>& system);
template <int Dim> std::vector<MapId> freshIds(const IteratedFunctionSystem<Dim>& system, std::size_t count);

// Appends a map under a fresh id, which is returned.
template <int Dim>
MapId append(IteratedFunctionSystem<Dim>& system, const AffineMap<Dim>& map,
             std::optional<double> weight = std::nullopt);

// γ∘w_i for every element of the group, the weight of w_i shared among them: for each map in turn the
// identity, which keeps the id, then the other elements in their order under fresh ids. The result has no
// symmetry. Beyond maxSymmetricMaps maps, or maxSymmetricLinkedMaps linked ones, it has lost its symmetry.
template <int Dim> IteratedFunctionSystem<Dim> expanded(const IteratedFunctionSystem<Dim>& system);
// Number of maps of activeMaps() for each listed map: |Γ|, and 1 beyond the limit.
template <int Dim> std::size_t copiesOfEachMap(const IteratedFunctionSystem<Dim>& system);

// The maps in their order, without weights, ids and symmetry.
template <int Dim> std::vector<AffineMap<Dim>> mapsOf(const IteratedFunctionSystem<Dim>& system);

// Probabilities of the listed maps, each with its copies under the symmetry: 0 for a map that is off and for
// no other, sum 1 unless every map is off. A disabled map and a weight ≤ 0 (or not finite) mean off. If any
// enabled map has no weight at all, the determinant rule serves for all maps that are not off.
template <int Dim> std::vector<double> probabilities(const IteratedFunctionSystem<Dim>& system);

// Maps of the expanded system that have a positive probability; `index` holds, in ascending order, the
// indices in `system` of the maps that they are copies of. Without a symmetry each index occurs once. Linked
// maps are those that the chaos game applies for ever: LinkState::TakesPart of ifs/system/links.h.
template <int Dim> struct ActiveMaps {
    std::vector<AffineMap<Dim>> maps;
    std::vector<double> probabilities;
    std::vector<std::size_t> index;
    std::vector<double> links{}; // P_ij row by row; empty if all weights within each row are equal

    bool isLinked() const { return !links.empty(); }
};
template <int Dim> ActiveMaps<Dim> activeMaps(const IteratedFunctionSystem<Dim>& system);
// Number of maps that activeMaps() holds.
template <int Dim> std::size_t countActive(const IteratedFunctionSystem<Dim>& system);

// The masses divided by their sum, none below `floor` of it before renormalising. A mass that is negative or
// not finite counts as 0; equal shares when every mass is 0.
std::vector<double> shares(std::vector<double> masses, double floor = 0);

// Weight rules. Each returns positive numbers that sum to 1, one per map (empty for no maps).
// Determinant rule: |det A_i|, none below `floor` of the sum before renormalising; equal if every determinant
// is 0.
template <int Dim>
std::vector<double> determinantWeights(std::span<const AffineMap<Dim>> maps, double floor = 0.01);
std::vector<double> equalWeights(std::size_t count);
// Dimension rule: φ^D(A_i), the singular value function at the affinity dimension D capped at Dim, floored
// alike.
template <int Dim>
std::vector<double> dimensionWeights(std::span<const AffineMap<Dim>> maps, double floor = 0.01);

// T∘w∘T⁻¹ for every map ("baking"): its attractor is T of the old one. Weights, ids and order stay, and
// the symmetry is that of the new attractor.
// nullopt when T is singular or its condition number exceeds 1e6, where the code would lose its digits.
template <int Dim>
std::optional<IteratedFunctionSystem<Dim>> conjugate(const AffineMap<Dim>& transformation,
                                                     const IteratedFunctionSystem<Dim>& system);

} // namespace ifs
