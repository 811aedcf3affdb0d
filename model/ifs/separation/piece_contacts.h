// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"
#include "ifs/separation/neighbour_graph.h"
#include "ifs/system/branch.h"

#include <vector>

// Contacts between the pieces w_i(A) of an attractor. docs/mathematics.md, "Separation".
namespace ifs {

// Two words, neither the beginning of the other, of one and the same map: the pieces coincide, and the open
// set condition fails.
struct Overlap {
    Word first, second;
    bool isExact = false; // the coefficients as they are; else as far as their rounding tells
};

enum class Separation {
    Unknown,
    Strong,      // proved: no two pieces have a common point (strong separation condition)
    Overlapping, // an overlap was found
};

enum class Connectedness {
    Unknown,
    Connected,           // proved: pieces with a common point join all of them (Hata)
    ConnectedToRounding, // the same, where common points agree to rounding only
    Disconnected,        // proved: the pieces fall into two classes without a common point
};

struct PieceContacts {
    Separation separation = Separation::Unknown;
    Connectedness connectedness = Connectedness::Unknown;
    std::vector<Overlap> overlaps; // the shortest, a few of them
};

// Bounded work: Unknown where it leaves a question open, and always for more than 64 maps. `neighbours`, if
// known, belongs to the same maps and tells which pieces meet.
template <int Dim>
PieceContacts pieceContacts(const SupportFunction<Dim>& support, const NeighbourGraph* neighbours = nullptr);

} // namespace ifs
