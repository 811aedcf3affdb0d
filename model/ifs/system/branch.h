// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <optional>
#include <span>
#include <vector>

// Addresses and the branches that they name. A word lists indices into the maps, outermost first.
// docs/mathematics.md, "Branches".
namespace ifs {

using Word = std::vector<int>;

// A word over the maps of a system as one over its active maps, whose indices in the system are `indices`,
// ascending; nullopt when it names a map that takes no part.
std::optional<Word> overMaps(const Word& word, std::span<const std::size_t> indices);

// w_σ; the identity for the empty word.
template <int Dim> AffineMap<Dim> composed(std::span<const AffineMap<Dim>> maps, const Word& word);

// φ(prefix·period·period·…) = w_prefix(fix(w_period)). nullopt when no single point is fixed.
template <int Dim>
std::optional<Vector<Dim>> addressPoint(std::span<const AffineMap<Dim>> maps, const Word& prefix,
                                        const Word& period);

// A word that leaves σ: its first symbols, `kept` of them, then another `symbol` than the next one of σ.
struct Departure {
    std::size_t kept;
    int symbol;
};
std::vector<Departure> departures(const Word& word, std::size_t mapCount); // those that keep most maps first

// σ, then all words that leave σ, as departures() has them: every address begins with exactly one of them.
// For three maps and σ = 12 (counted from 1): 12, 11, 13, 2, 3.
std::vector<Word> cutSet(const Word& word, std::size_t mapCount);

// The same attractor from the maps w_τ over the cut set of σ, in its order and with their probabilities, but
// with change∘w_σ for w_σ. Words are over activeMaps(system). The change shows at every scale.
template <int Dim>
IteratedFunctionSystem<Dim> withBranchChanged(const IteratedFunctionSystem<Dim>& system, const Word& branch,
                                              const AffineMap<Dim>& change);

// A branch that is shown elsewhere: points whose address begins with `word` go through `change`, in
// coordinates of the code, when they are displayed. No orbit takes notice: nothing else moves, at no scale.
template <int Dim> struct MovedBranch {
    Word word;
    AffineMap<Dim> change;

    friend bool operator==(const MovedBranch&, const MovedBranch&) = default;
};

// The pieces of an attractor A whose branches are moved: the union of change(w_word(A)) over words with
// exactly one of which every address begins. Among nested branches the inner one moves first. At most 1 +
// (maps − 1)·Σ lengths of the words pieces, in lexicographic order. Branches with words longer than `longest`
// stay.
template <int Dim>
std::vector<MovedBranch<Dim>> pieces(std::span<const MovedBranch<Dim>> moved, std::size_t mapCount,
                                     std::size_t longest = std::size_t(-1));

// change∘w_word of each piece.
template <int Dim>
std::vector<AffineMap<Dim>> pieceMaps(std::span<const MovedBranch<Dim>> pieces,
                                      std::span<const AffineMap<Dim>> maps);

// The piece with which an address begins. At least as much of the address must be given as the longest word
// has.
template <int Dim>
const MovedBranch<Dim>& pieceOf(std::span<const MovedBranch<Dim>> pieces, const Word& address);

// Moved branches with words over the maps of a system as ones over its active maps, whose indices in the
// system are `indices`, ascending; what names a map that takes no part is left out.
template <int Dim>
std::vector<MovedBranch<Dim>> overMaps(std::span<const MovedBranch<Dim>> moved,
                                       std::span<const std::size_t> indices);

// The words over the cut set of `branch`, as indices into it, with one of which an address begins if and only
// if it begins with `word`: the branches to move in withBranchChanged(system, branch, {}) so that `word`
// moves.
std::vector<Word> overCutSet(const Word& word, const Word& branch, std::size_t mapCount);

} // namespace ifs
