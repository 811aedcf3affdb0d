// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/folds/fold.h"

#include <memory>

namespace attractor {

// What the algorithm folds. `prepared` outlives it.
std::unique_ptr<Fold> makeFold(Algorithm algorithm, const PreparedRequest& prepared);

} // namespace attractor
