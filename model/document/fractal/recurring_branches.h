// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/system/branch.h"

#include <span>
#include <vector>

// Branches that change inside themselves: ifs::recurring(). Their word is MapId::None, then the address, so
// that all that knows branches by their words (keys, undo, files) tells them from those that are moved once.
namespace document {

inline bool recurs(std::span<const ifs::MapId> word) {
    return !word.empty() && word.front() == ifs::MapId::None;
}
// The word of a branch that changes inside itself, with this address.
std::vector<ifs::MapId> recurringWord(std::vector<ifs::MapId> address);

// Branches as stored in Shape::moved, with words over indices into the system. Branches with a map that is
// gone are left out.
template <int Dim> struct StoredBranch {
    ifs::MovedBranch<Dim> branch;
    bool recurs = false;
};
template <int Dim> std::vector<StoredBranch<Dim>> storedBranches(const Shape<Dim>& shape);

} // namespace document
