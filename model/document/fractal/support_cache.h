// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/control_cage.h"
#include "ifs/extent/support_function.h"
#include "ifs/system/iterated_function_system.h"

#include <memory>

namespace document {

// The extents of a fractal's last few systems of many maps, shared with every fractal copied from it: while
// only the cage moves, the same is asked for again and again. No part of a value: any two are equal.
class SupportCache {
public:
    SupportCache();

    // The extent of the attractor of the maps that take part; nullptr when they have none. Any thread.
    std::shared_ptr<const ifs::SupportFunction<2>>
    support(const ifs::IteratedFunctionSystem<2>& system) const;
    std::shared_ptr<const ifs::SupportFunction<3>>
    support(const ifs::IteratedFunctionSystem<3>& system) const;

    // The minimal canonical simplex at rest; a unit tetrahedron without an attractor. Any thread. Two that
    // ask for the same system at once wait for one answer.
    ifs::ControlCage<3> simplexInSpace(const ifs::IteratedFunctionSystem<3>& system) const;
    // Returns true if simplexInSpace() is fast, because the maps are few or the result is cached.
    bool isSimplexKnown(const ifs::IteratedFunctionSystem<3>& system) const;

    friend bool operator==(const SupportCache&, const SupportCache&) { return true; }

private:
    struct Newest;
    std::shared_ptr<Newest> m_newest; // null after a move
};

// Number of maps in space from which on extents take long enough to be found in the background, and to a
// hundredth of the size.
constexpr std::size_t manyMapsInSpace = 10'000;
// Tolerance of extents in space relative to their size: nobody sees more digits.
double extentTolerance(const ifs::IteratedFunctionSystem<3>& system);
// The minimal canonical simplex around an attractor with that extent, to this tolerance.
ifs::Simplex<3> simplexAround(const ifs::IteratedFunctionSystem<3>& system,
                              const ifs::SupportFunction<3>& support);

} // namespace document
