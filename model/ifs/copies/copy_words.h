// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/copies/copy.h"
#include "ifs/copies/copy_projection.h"
#include "ifs/system/branch.h"

namespace ifs {

// A picture written out word by word: every copy by its own matrix, as large as it can be while it is thinner
// than can be seen, as dots and as projections thick enough to be seen.
struct CopyWords {
    struct Word {
        Copy copy;
        AffineMap<2> map; // product that the copy stands for
    };
    std::vector<Word> words; // grouped by outermost map
    std::vector<CopyProjection> projections;
};

// `pieces` as of ifs::pieces. Copies count projections from `firstProjection`. nullopt when that would be a
// large file.
std::optional<CopyWords> copyWords(const std::vector<AffineMap<2>>& maps,
                                   std::span<const MovedBranch<2>> pieces, const CopyFrame& frame,
                                   std::size_t firstProjection);

} // namespace ifs
