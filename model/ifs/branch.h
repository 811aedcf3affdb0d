// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/iterated_function_system.h"

#include <optional>
#include <span>
#include <vector>

// Addresses and the branches that they name. A word lists indices into the maps, outermost first.
// docs/mathematics.md, "Branches".
namespace ifs {

using Word = std::vector<int>;

// w_σ; the identity for the empty word.
template <int Dim> AffineMap<Dim> composed(std::span<const AffineMap<Dim>> maps, const Word& word);

// φ(prefix·period·period·…) = w_prefix(fix(w_period)). nullopt when no single point is fixed.
template <int Dim>
std::optional<Vector<Dim>> addressPoint(std::span<const AffineMap<Dim>> maps, const Word& prefix,
                                        const Word& period);

// σ, then all words that leave σ at some symbol: every address begins with exactly one of them. For three
// maps and σ = 12 (counted from 1): 12, 11, 13, 2, 3.
std::vector<Word> cutSet(const Word& word, std::size_t mapCount);

// The same attractor from the maps w_τ over the cut set of σ, in its order and with their probabilities, but
// with change∘w_σ for w_σ. Words are over activeMaps(system). The change shows at every scale.
template <int Dim>
IteratedFunctionSystem<Dim> withBranchChanged(const IteratedFunctionSystem<Dim>& system, const Word& branch,
                                              const AffineMap<Dim>& change);

} // namespace ifs
