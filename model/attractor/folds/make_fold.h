// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/folds/fold.h"

#include <memory>

namespace attractor {

// The fold of an algorithm. `prepared` must outlive it.
std::unique_ptr<Fold> makeFold(Algorithm algorithm, const PreparedRequest& prepared);

} // namespace attractor
