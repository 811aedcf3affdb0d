// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <span>
#include <vector>

namespace ifs {

enum class Verdict {
    Hyperbolic,            // all maps contract
    EventuallyContractive, // all words of some length contract: an attractor exists all the same
    None,                  // ρ ≥ 1 is proved of some word: the maps contract in no norm
    Undecided,             // not settled within the permitted work
    Empty,                 // no map takes part
};

// Kind of norm in which all maps contract.
enum class NormKind {
    Euclidean,
    Words,       // max over k < n of γ^(−k)·max |A_σ x| over the words σ of length k
    Ellipsoidal, // √(xᵀPx)
    Polytope,    // norm whose unit ball is a polytope
};

struct Existence {
    Verdict verdict = Verdict::Undecided;
    // Hyperbolic: s = max ‖A_i‖. EventuallyContractive: γ = (max ‖A_σ‖ over |σ| = wordLength)^(1/wordLength);
    // or, with wordLength 1, max ‖A_i‖ in a norm that is not Euclidean; 1 where that is proved to be below 1
    // but too near it for a double. Undecided: the smallest γ found. None: ρ(A_σ)^(1/|σ|) ≥ 1 of the witness.
    double contractivity = 0;
    int wordLength = 1;
    // Evidence for the verdict. None: a word (indices into the maps, outermost first) whose spectral radius
    // is proved to be at least 1. Hyperbolic and EventuallyContractive: a word of wordLength with the largest
    // norm.
    std::vector<int> witness{};
    // C with |x| ≤ ‖x‖_* ≤ C|x|, where every map contracts by `contractivity` in ‖·‖_*; 1 when Hyperbolic. Of
    // longer words by 1e-3 at least: where products vanish, no norm shows it.
    double normEquivalence = 1;
    NormKind norm = NormKind::Euclidean; // Hyperbolic and EventuallyContractive

    bool exists() const {
        return verdict == Verdict::Hyperbolic || verdict == Verdict::EventuallyContractive;
    }
    // Returns true if a factor below 1 is known: extents and everything made of them need one.
    bool hasFactor() const { return exists() && contractivity < 1; }
};

// Decides whether the maps have an attractor, with a certificate. At most `maxProducts` words are multiplied
// out. Maps with a coefficient that is not finite are Undecided. docs/mathematics.md, "When does a system
// have an attractor?"
template <int Dim> Existence classify(std::span<const AffineMap<Dim>> maps, int maxProducts = 20'000);

// A norm in which every map contracts by `contractivity`, with |x| ≤ ‖x‖ ≤ equivalence·|x| after scaling:
// ‖x‖ = |root·x| when every root·A_i·root⁻¹ has a norm below 1, and else ‖·‖_* of longer words, or the norm
// that decided existence, root = I.
template <int Dim> struct ContractingNorm {
    Matrix<Dim> root = Matrix<Dim>::Identity();
    double contractivity = 0;
    double equivalence = 1;
    NormKind norm = NormKind::Euclidean;
    int wordLength = 1; // NormKind::Words only
};

// The norm with the smallest equivalence/(1 − contractivity), by which certificates widen, among those of
// words and the ellipsoidal ones. `existence` must have a factor.
template <int Dim>
ContractingNorm<Dim> contractingNorm(std::span<const AffineMap<Dim>> maps, const Existence& existence);

// An interval that holds the joint spectral radius lim max ‖A_σ‖^(1/n) over the words σ of length n → ∞; both
// ends are proved, and infinite or 0 where nothing is known. `existence` is that of the same maps.
struct JointSpectralRadius {
    double least = 0, most = 0;
};
template <int Dim>
JointSpectralRadius jointSpectralRadius(std::span<const AffineMap<Dim>> maps, const Existence& existence);

} // namespace ifs
