// SPDX-License-Identifier: MIT
#pragma once

#include "document/analysis.h"

namespace document {

// What of the facts of an entry in space can be drawn over its picture. `code` are those of the code,
// `displayed` those of the picture, which an affine map `placed` makes of it.
struct SpaceFacts {
    const ifs::Facts<3>& code;
    const ifs::Facts<3>& displayed;
    ifs::AffineMap<3> placed;
};
std::vector<SpaceOutline> spaceOutlines(const SpaceFacts& facts, const AnalysisRequest& request);

} // namespace document
