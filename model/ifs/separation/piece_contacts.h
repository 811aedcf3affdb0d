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
    bool isExact = false; // true: holds for the exact coefficients; false: up to their rounding
};

enum class Separation {
    Unknown,
    Strong,      // proved strong separation condition: no two pieces have a common point
    Overlapping, // proved overlap
};

enum class Connectedness {
    Unknown,
    Connected,           // proved: pieces with a common point join all pieces (Hata)
    ConnectedToRounding, // Connected, with common points that agree only up to rounding
    Disconnected,        // proved: two classes of pieces have no common point
};

struct PieceContacts {
    Separation separation = Separation::Unknown;
    Connectedness connectedness = Connectedness::Unknown;
    std::vector<Overlap> overlaps; // a few of the shortest
};

// Bounded work: Unknown where it leaves a question open, and always for more than 64 maps. `neighbours`, if
// known, belongs to the same maps and tells which pieces meet.
template <int Dim>
PieceContacts pieceContacts(const SupportFunction<Dim>& support, const NeighbourGraph* neighbours = nullptr);

} // namespace ifs
