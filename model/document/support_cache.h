// SPDX-License-Identifier: MIT
#pragma once

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

    friend bool operator==(const SupportCache&, const SupportCache&) { return true; }

private:
    struct Newest;
    std::shared_ptr<Newest> m_newest; // null when moved from
};

} // namespace document
