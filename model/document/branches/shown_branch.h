// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/system/branch.h"

#include <vector>

// Branches as they are shown, in coordinates of the code. Words have indices of maps of the system.
namespace document {

// The total motion of a branch: its own and those of the branches around it.
template <int Dim> ifs::AffineMap<Dim> movedBy(const Shape<Dim>& shape, const ifs::Word& branch);

// A branch as the one map within(map(·)), to be moved by changes of Shape::moved.
template <int Dim> struct ShownBranch {
    std::vector<ifs::MapId> word; // word of the change: recurringWord(), if it recurs
    ifs::AffineMap<Dim> within;   // constant outer map, also moved by the change
    ifs::AffineMap<Dim> map;
};
template <int Dim>
ShownBranch<Dim> shownBranch(const Shape<Dim>& shape, const ifs::Word& branch, bool recurs);

// `change` after what the branch with that word is moved by so far.
template <int Dim>
void moveShown(Shape<Dim>& shape, const std::vector<ifs::MapId>& word, const ifs::AffineMap<Dim>& change);

template <int Dim> bool isMoved(const Shape<Dim>& shape, const ifs::Word& branch);
// The branch goes where its maps put it; nothing happens where there is no such branch.
template <int Dim> void putBack(Shape<Dim>& shape, const ifs::Word& branch);

// change∘w_σ of a branch that changes inside itself, which it does only where this contracts; w_σ of others.
template <int Dim> ifs::AffineMap<Dim> recurringMap(const Shape<Dim>& shape, const ifs::Word& branch);

} // namespace document
