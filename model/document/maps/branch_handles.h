// SPDX-License-Identifier: MIT
#pragma once

#include "document/maps/map_handles.h"
#include "document/maps/space_map_handles.h"

#include <memory>
#include <optional>
#include <type_traits>

namespace document {

// A branch σ, a word of indices in the system, as a map that can be moved.
template <int Dim> struct BranchHandles {
    std::conditional_t<Dim == 2, MapHandles, SpaceMapHandles> handles;
    std::size_t index = 0;
};

// nullopt when the word is empty or names a map that takes no part, and for BranchEdit::OwnMap of more than
// one symbol where maps are linked: the maps that divide the others would have links of their own.
template <int Dim>
std::optional<BranchHandles<Dim>> branchHandles(const std::shared_ptr<const Fractal>& fractal,
                                                const ifs::ControlCage<Dim>& cage, const ifs::Word& branch,
                                                BranchEdit edit);

} // namespace document
