// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <cstddef>
#include <optional>

namespace ifs {

// A copy in a picture that is put together from copies of the attractor: of an outline (level 0), of a level
// above it, or of a projection.
struct Copy {
    AffineMap<2> map; // regular
    int level = 0;
    std::optional<std::size_t> projection;
    std::optional<std::size_t> first; // outermost map; nullopt: the whole attractor
};

// `map` with every singular value below `least` raised to it; the image of `centre` stays. Drawing programs
// refuse singular matrices.
AffineMap<2> thickened(const AffineMap<2>& map, const Vector<2>& centre, double least);

} // namespace ifs
