// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/coupled_system.h"
#include "document/fractal/fractal.h"
#include "ifs/extent/support_function.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace document {

// Positions of active maps, whose indices in the system are given, in the order that lists these indices, the
// one on top first; empty: as they are. Copies of a map under a symmetry stay together, in their order.
// nullopt where the order does not name each map once.
std::optional<std::vector<std::size_t>> placesInOrder(std::span<const std::size_t> order,
                                                      const std::vector<std::size_t>& indices);

// Two entries whose maps correspond, for a fractal transformation from the first to the second: of the maps
// that take part, the k-th of one goes with the k-th of the other.
struct CoupledEntries {
    Fractal from, to; // entries as their cages place them, without cages and moved branches
    // Attractors of the maps that take part, first the map on top.
    ifs::SupportFunction<2> fromAttractor, toAttractor;
    std::vector<double> probabilities; // probabilities of the maps of `from`
    std::vector<std::size_t> numbers;  // indices of these maps in the entry `from`

    attractor::CoupledSystem system() const { return {fromAttractor, toAttractor, probabilities}; }
};

// Why there is no transformation; of the first or the second entry, where it is one of them.
enum class CouplingFlaw {
    NotInPlane,
    BentCage, // flat or bent cage: no code has the picture
    NoMaps,
    Linked,
    NoAttractor, // no attractor is proved
    Counts,      // different numbers of maps take part
    Order,       // `order` is no permutation of the first entry's maps that take part
};
struct CouplingOutcome {
    std::optional<CoupledEntries> entries;
    CouplingFlaw flaw = CouplingFlaw::Counts; // valid if there are no entries
    bool isOfSecond = false;
    std::size_t fromCount = 0, toCount = 0; // numbers of maps that take part
};

// `order` is that of the maps of the first entry, as in placesInOrder(). What `before` knows of the second
// entry is taken from there if that is the same: its extent takes as long as that of the first.
CouplingOutcome coupled(const Fractal& from, const Fractal& to, std::span<const std::size_t> order,
                        const std::optional<CoupledEntries>& before = std::nullopt);

// The objections of coupled() that need no attractors, which may take long to find.
std::optional<CouplingOutcome> evidentFlaw(const Fractal& from, const Fractal& to,
                                           std::span<const std::size_t> order);

} // namespace document
