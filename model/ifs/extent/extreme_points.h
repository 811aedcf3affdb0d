// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/convex_hull.h"
#include "ifs/system/branch.h"

#include <optional>
#include <stop_token>
#include <vector>

// Extreme points of an attractor that have an eventually periodic address, and are therefore known exactly.
// docs/mathematics.md, "Extreme points with periodic addresses".
namespace ifs {

struct PeriodicPoint {
    Word prefix;
    Word period;     // least length; chosen to make the prefix as short as possible
    Vector<2> point; // φ(prefix period period …), to rounding
};

// The extreme points that the vertices of a hull of the attractor stand for. nullopt where no periodic
// address was found, or none could be proved: some direction must exist in which every symbol of the address
// wins by more than the error, or leads to the same point as the winner. When stopped, some are missing.
std::vector<std::optional<PeriodicPoint>> periodicExtremePoints(const SupportFunction<2>& support,
                                                                const ConvexHull& hull,
                                                                const std::stop_token& stop = {});

} // namespace ifs
